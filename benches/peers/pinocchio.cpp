// Pinocchio in C++: values at every state of model.txt, and times. Usage: pinocchio model.txt > result.json
#include <cstdio>

#include "model.hpp"
#include "timing.hpp"
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/algorithm/regressor.hpp>
#include <pinocchio/algorithm/rnea.hpp>

template <class M>
void print(const char* name, const M& m, bool last = false) {
  std::printf("\"%s\":[", name);
  for (int i = 0; i < m.rows(); ++i)
    for (int j = 0; j < m.cols(); ++j) std::printf("%s%.17g", i + j ? "," : "", m(i, j));
  std::printf("]%s", last ? "" : ",");
}

int main(int, char** argv) {
  const Description description(argv[1]);
  const pinocchio::Model model = description.model();
  pinocchio::Data data(model);
  const int n = description.n;
  const auto vector = [&](const std::vector<double>& v) { return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(v.data(), n)); };
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(6, n);
  const auto frame = [&](const Eigen::VectorXd& q) {
    jacobian.setZero();
    pinocchio::computeJointJacobians(model, data, q);
    pinocchio::getJointJacobian(model, data, n, pinocchio::LOCAL_WORLD_ALIGNED, jacobian);
  };
  std::printf("{\"states\":[");
  for (size_t s = 0; s < description.states.size(); ++s) {
    const auto& state = description.states[s];
    const Eigen::VectorXd q = vector(state[0]), dq = vector(state[1]), ddq = vector(state[2]);
    std::printf("%s{", s ? "," : "");
    const Eigen::MatrixXd w = pinocchio::computeJointTorqueRegressor(model, data, q, dq, ddq);
    Eigen::MatrixXd ours(n, 10 * n);
    for (int k = 0; k < 10 * n; ++k) ours.col(k) = w.col(Description::column(k));
    print("regressor", ours);
    print("inverse_dynamics", Eigen::MatrixXd(pinocchio::rnea(model, data, q, dq, ddq)));
    pinocchio::crba(model, data, q);
    print("mass_matrix", Eigen::MatrixXd(data.M.selfadjointView<Eigen::Upper>()));
    print("gravity", Eigen::MatrixXd(pinocchio::computeGeneralizedGravity(model, data, q)));
    frame(q);
    print("jacobian", jacobian);
    pinocchio::forwardKinematics(model, data, q);
    print("forward_kinematics", Eigen::MatrixXd(data.oMi[n].toHomogeneousMatrix()), true);
    std::printf("}");
  }
  const auto& state = description.states[0];
  const Eigen::VectorXd q = vector(state[0]), dq = vector(state[1]), ddq = vector(state[2]);
  std::printf("],\"ns\":{\"regressor\":%.1f,", nanoseconds([&] { pinocchio::computeJointTorqueRegressor(model, data, q, dq, ddq); }));
  std::printf("\"inverse_dynamics\":%.1f,", nanoseconds([&] { pinocchio::rnea(model, data, q, dq, ddq); }));
  std::printf("\"mass_matrix\":%.1f,", nanoseconds([&] { pinocchio::crba(model, data, q); }));
  std::printf("\"gravity\":%.1f,", nanoseconds([&] { pinocchio::computeGeneralizedGravity(model, data, q); }));
  std::printf("\"jacobian\":%.1f,", nanoseconds([&] { frame(q); }));
  std::printf("\"forward_kinematics\":%.1f}}\n", nanoseconds([&] { pinocchio::forwardKinematics(model, data, q); }));
}
