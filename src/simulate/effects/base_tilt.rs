//! `base_tilt`: the true base is the given one turned by `RotY(pitch) RotX(roll)`; gravity stays where it is, so in base axes it turns
//! the other way.

use super::Given;

/// Gravity in the axes of the tilted base.
pub(crate) fn tilted(gravity: [f64; 3], given: &Given<'_>) -> [f64; 3] {
    let (roll, pitch) = (given.get("roll"), given.get("pitch"));
    let ((sr, cr), (sp, cp)) = (libm::sincos(roll), libm::sincos(pitch));
    // The columns of RotY(pitch) RotX(roll).
    let columns = [[cp, 0.0, -sp], [sp * sr, cr, cp * sr], [sp * cr, -sr, cp * cr]];
    columns.map(|c| (0..3).map(|k| c[k] * gravity[k]).sum())
}

#[cfg(test)]
mod tests {
    use super::*;
    use dh_codegen::robot::Effect;

    #[test]
    fn gravity_leans_away_from_the_tilt() {
        let effect = |roll: f64, pitch: f64| Effect {
            name: "base_tilt".into(),
            parameters: vec![("roll".into(), roll), ("pitch".into(), pitch)],
        };
        let g = tilted([0.0, 0.0, -9.81], &Given::new(&effect(0.1, 0.0), None));
        assert!(g[0].abs() < 1e-15 && (g[1] + 9.81 * 0.1f64.sin()).abs() < 1e-12, "{g:?}");
        let g = tilted([0.0, 0.0, -9.81], &Given::new(&effect(0.0, 0.1), None));
        assert!((g[0] - 9.81 * 0.1f64.sin()).abs() < 1e-12 && g[1].abs() < 1e-15, "{g:?}");
    }
}
