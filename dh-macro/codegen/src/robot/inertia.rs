//! The ten inertial parameters of a rigid body.

/// Mass, first moments and inertia tensor of a body, about the origin of the frame in which they
/// are expressed.
///
/// The products of inertia are the tensor's entries: `XY = -integral of x y dm`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Inertia {
    /// Mass, kg.
    pub m: f64,
    /// First moments `MSX MSY MSZ`, kg m.
    pub ms: [f64; 3],
    /// Tensor `XX YY ZZ XY XZ YZ`, kg m^2.
    pub i: [f64; 6],
}

impl Inertia {
    /// The parameters in the paper's order: `M MSX MSY MSZ XX YY ZZ XY XZ YZ`.
    pub fn to_array(self) -> [f64; 10] {
        let [xx, yy, zz, xy, xz, yz] = self.i;
        [self.m, self.ms[0], self.ms[1], self.ms[2], xx, yy, zz, xy, xz, yz]
    }

    /// Parameters from an array in the paper's order.
    pub fn from_array(p: [f64; 10]) -> Self {
        Self { m: p[0], ms: [p[1], p[2], p[3]], i: [p[4], p[5], p[6], p[7], p[8], p[9]] }
    }

    /// Sum of two bodies in the same frame.
    pub fn plus(&self, other: &Self) -> Self {
        let (a, b) = (self.to_array(), other.to_array());
        Self::from_array(core::array::from_fn(|k| a[k] + b[k]))
    }

    /// Inertia tensor as a symmetric matrix.
    pub fn tensor(&self) -> [[f64; 3]; 3] {
        let [xx, yy, zz, xy, xz, yz] = self.i;
        [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    }

    /// The same body in another frame: `rotation` (row-major) and `origin` (m) are those of the
    /// present frame in the new one.
    ///
    /// `MS' = R MS + m p`; `I' = R I R' + (2 (p . R MS) + m p . p) E - (p (R MS)' + (R MS) p') - m
    /// p p'`.
    pub fn moved(&self, rotation: &[[f64; 3]; 3], origin: &[f64; 3]) -> Self {
        let (r, p, t) = (rotation, origin, self.tensor());
        let l: [f64; 3] = core::array::from_fn(|i| (0..3).map(|k| r[i][k] * self.ms[k]).sum());
        let trace = (0..3).map(|k| 2.0 * p[k] * l[k] + self.m * p[k] * p[k]).sum::<f64>();
        let entry = |i: usize, j: usize| {
            let turned: f64 =
                (0..3).flat_map(|a| (0..3).map(move |b| (a, b))).map(|(a, b)| r[i][a] * t[a][b] * r[j][b]).sum();
            let diagonal = if i == j { trace } else { 0.0 };
            turned + diagonal - p[i] * l[j] - l[i] * p[j] - self.m * p[i] * p[j]
        };
        Self {
            m: self.m,
            ms: core::array::from_fn(|k| l[k] + self.m * p[k]),
            i: [entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A body as a cloud of points: moving the points and summing gives the same result.
    #[test]
    fn moving_a_body_is_moving_its_points() {
        let points = [(0.7, [0.1, -0.2, 0.3]), (1.1, [-0.4, 0.25, 0.05]), (0.3, [0.6, 0.1, -0.7])];
        let sum = |f: &dyn Fn([f64; 3]) -> [f64; 3]| {
            points.iter().fold(Inertia::default(), |sum, (m, x)| {
                let [x, y, z] = f(*x);
                let i = [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z];
                sum.plus(&Inertia { m: *m, ms: [m * x, m * y, m * z], i: i.map(|v| m * v) })
            })
        };
        let (s, c) = 0.3f64.sin_cos();
        let (r, p) = ([[c, -s, 0.0], [0.0, 0.0, -1.0], [s, c, 0.0]], [0.2, -0.5, 0.9]);
        let direct = sum(&|x| core::array::from_fn(|i| p[i] + (0..3).map(|k| r[i][k] * x[k]).sum::<f64>()));
        let moved = sum(&|x| x).moved(&r, &p);
        for (a, b) in direct.to_array().iter().zip(moved.to_array()) {
            assert!((a - b).abs() < 1e-14, "{a} {b}");
        }
    }
}
