// C text by CasADi from Pinocchio's algorithms over SX, the arm's parameters as numbers. Usage: casadi_write model.txt kernels.c
#include <casadi/casadi.hpp>
#include <pinocchio/autodiff/casadi.hpp>

#include "model.hpp"
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/algorithm/regressor.hpp>
#include <pinocchio/algorithm/rnea.hpp>

using casadi::SX;
using Vector = Eigen::Matrix<SX, Eigen::Dynamic, 1>;

template <class M>
SX sx(const M& m) {
  SX out = SX::zeros(m.rows(), m.cols());
  for (int i = 0; i < m.rows(); ++i)
    for (int j = 0; j < m.cols(); ++j) out(i, j) = m(i, j);
  return out;
}

int main(int, char** argv) {
  const Description description(argv[1]);
  const int n = description.n;
  const auto model = description.model().cast<SX>();
  pinocchio::DataTpl<SX> data(model);
  const auto input = [&](const char* name) { return SX::sym(name, n); };
  const auto vector = [&](const SX& s) {
    Vector v(n);
    for (int i = 0; i < n; ++i) v[i] = s(i);
    return v;
  };
  const SX sq = input("q"), sv = input("dq"), sa = input("ddq");
  const Vector q = vector(sq), v = vector(sv), a = vector(sa);
  casadi::CodeGenerator text(argv[2]);
  const auto add = [&](const char* name, const std::vector<SX>& in, const SX& out) {
    // Dense, row-major: what the caller of ours gets.
    text.add(casadi::Function(name, in, {densify(out.T())}));
  };

  const Eigen::Matrix<SX, Eigen::Dynamic, Eigen::Dynamic> w = pinocchio::computeJointTorqueRegressor(model, data, q, v, a);
  const SX full = sx(w);
  std::vector<SX> columns, base;
  for (int k = 0; k < 10 * n; ++k) columns.push_back(full(casadi::Slice(), Description::column(k)));
  for (int k : description.leaders) base.push_back(columns[k]);
  add("regressor", {sq, sv, sa}, cse(SX::horzcat(columns)));
  add("base_regressor", {sq, sv, sa}, cse(SX::horzcat(base)));
  add("inverse_dynamics", {sq, sv, sa}, cse(sx(pinocchio::rnea(model, data, q, v, a))));
  pinocchio::crba(model, data, q);
  SX mass = sx(data.M);
  add("mass_matrix", {sq}, cse(SX::triu2symm(SX::triu(mass))));
  add("gravity", {sq}, cse(sx(pinocchio::computeGeneralizedGravity(model, data, q))));
  Eigen::Matrix<SX, 6, Eigen::Dynamic> jacobian(6, n);
  jacobian.setZero();
  pinocchio::computeJointJacobians(model, data, q);
  pinocchio::getJointJacobian(model, data, n, pinocchio::LOCAL_WORLD_ALIGNED, jacobian);
  add("jacobian", {sq}, cse(sx(jacobian)));
  pinocchio::forwardKinematics(model, data, q);
  add("forward_kinematics", {sq}, cse(sx(data.oMi[n].toHomogeneousMatrix())));
  text.generate();
}
