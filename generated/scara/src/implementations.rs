//! The traits of every robot, for code that is generic over robots.

/// This robot as a type.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Robot;

impl super::robot::Description for Robot {
    const NAME: &'static str = super::NAME;
    const DOF: usize = super::DOF;
    const ROWS: usize = super::ROWS;
    const STANDARD: usize = super::STANDARD;
    const BASE: usize = super::BASE;
    const JOINT_NAMES: &'static [&'static str] = &super::JOINT_NAMES;
    const STANDARD_NAMES: &'static [&'static str] = &super::STANDARD_NAMES;
    const BASE_NAMES: &'static [&'static str] = &super::BASE_NAMES;
    const GRAVITY: [f64; 3] = super::GRAVITY;
    const POSITION_LIMITS: &'static [Option<[f64; 2]>] = &super::POSITION_LIMITS;
    const VELOCITY_LIMITS: &'static [Option<f64>] = &super::VELOCITY_LIMITS;
    const ACCELERATION_LIMITS: &'static [Option<f64>] = &super::ACCELERATION_LIMITS;
    const TORQUE_LIMITS: &'static [Option<f64>] = &super::TORQUE_LIMITS;
}

impl<S: super::runtime::Scalar> super::robot::Kinematics<{ super::DOF }, S> for Robot {
    fn forward_kinematics(&self, q: &[S; super::DOF]) -> [[S; 4]; 3] {
        super::forward_kinematics(q)
    }
    fn tool_pose(&self, q: &[S; super::DOF]) -> [[S; 4]; 3] {
        super::tool_pose(q)
    }
    fn jacobian(&self, q: &[S; super::DOF]) -> [[S; super::DOF]; 6] {
        super::jacobian(q)
    }
    fn tool_jacobian(&self, q: &[S; super::DOF]) -> [[S; super::DOF]; 6] {
        super::tool_jacobian(q)
    }
    fn jacobian_dot_velocity(&self, q: &[S; super::DOF], dq: &[S; super::DOF]) -> [S; 6] {
        super::jacobian_dot_velocity(q, dq)
    }
}

impl<S: super::runtime::Scalar> super::robot::Dynamics<{ super::DOF }, S> for Robot {
    type Standard = [S; super::STANDARD];
    type Base = [S; super::BASE];
    fn standard_values(&self) -> Option<[S; super::STANDARD]> {
        super::STANDARD_VALUES.map(|values| values.map(<S as super::runtime::Scalar>::constant))
    }
    fn base_parameters(&self, phi: &[S; super::STANDARD]) -> [S; super::BASE] {
        super::base_parameters(phi)
    }
    fn inverse_dynamics(&self, q: &[S; super::DOF], dq: &[S; super::DOF], ddq: &[S; super::DOF], phi: &[S; super::STANDARD]) -> [S; super::DOF] {
        super::inverse_dynamics(q, dq, ddq, phi)
    }
    fn inverse_dynamics_base(&self, q: &[S; super::DOF], dq: &[S; super::DOF], ddq: &[S; super::DOF], beta: &[S; super::BASE]) -> [S; super::DOF] {
        super::inverse_dynamics_base(q, dq, ddq, beta)
    }
    fn mass_matrix(&self, q: &[S; super::DOF], beta: &[S; super::BASE]) -> [[S; super::DOF]; super::DOF] {
        super::mass_matrix(q, beta)
    }
    fn coriolis(&self, q: &[S; super::DOF], dq: &[S; super::DOF], beta: &[S; super::BASE]) -> [S; super::DOF] {
        super::coriolis(q, dq, beta)
    }
    fn gravity(&self, q: &[S; super::DOF], beta: &[S; super::BASE]) -> [S; super::DOF] {
        super::gravity(q, beta)
    }
    fn forward_dynamics(&self, q: &[S; super::DOF], dq: &[S; super::DOF], tau: &[S; super::DOF], beta: &[S; super::BASE]) -> [S; super::DOF] {
        super::forward_dynamics(q, dq, tau, beta)
    }
    fn regressor(&self, q: &[S; super::DOF], dq: &[S; super::DOF], ddq: &[S; super::DOF]) -> [[S; super::STANDARD]; super::DOF] {
        super::regressor(q, dq, ddq)
    }
    fn base_regressor(&self, q: &[S; super::DOF], dq: &[S; super::DOF], ddq: &[S; super::DOF]) -> [[S; super::BASE]; super::DOF] {
        super::base_regressor(q, dq, ddq)
    }
    fn payload_regressor(&self, q: &[S; super::DOF], dq: &[S; super::DOF], ddq: &[S; super::DOF]) -> [[S; 10]; super::DOF] {
        super::payload_regressor(q, dq, ddq)
    }
    fn kinetic_energy_regressor(&self, q: &[S; super::DOF], dq: &[S; super::DOF]) -> [S; super::STANDARD] {
        super::kinetic_energy_regressor(q, dq)
    }
    fn potential_energy_regressor(&self, q: &[S; super::DOF]) -> [S; super::STANDARD] {
        super::potential_energy_regressor(q)
    }
}

impl super::robot::InverseKinematics<{ super::DOF }> for Robot {
    fn inverse_kinematics(
        &self,
        pose: &[[f64; 4]; 3],
        query: &super::ik::Query<'_, { super::DOF }>,
    ) -> Result<super::ik::Solutions<{ super::DOF }>, super::ik::PoseError> {
        super::inverse_kinematics(pose, query)
    }
    fn tool_inverse_kinematics(
        &self,
        pose: &[[f64; 4]; 3],
        query: &super::ik::Query<'_, { super::DOF }>,
    ) -> Result<super::ik::Solutions<{ super::DOF }>, super::ik::PoseError> {
        super::tool_inverse_kinematics(pose, query)
    }
    fn arm(&self) -> super::ik::Arm<{ super::DOF }> {
        super::IK
    }
    fn redundancy(&self, q: &[f64; super::DOF], reference: &super::ik::Reference) -> f64 {
        super::IK.redundancy(q, reference)
    }
}
