// The robot of model.txt (written by table.py) as a Pinocchio model, for any scalar.
#pragma once
#include <array>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <pinocchio/multibody.hpp>

struct Description {
  int n = 0;
  std::vector<std::array<double, 4>> rows;      // alpha, d, theta, r (modified DH)
  std::vector<std::array<double, 10>> bodies;   // M MSX MSY MSZ XX YY ZZ XY XZ YZ about the frame's origin
  std::vector<int> leaders;                     // columns of the regressor (ours, 10 a link) that make the base regressor
  std::vector<std::array<std::vector<double>, 3>> states;  // q, dq, ddq

  explicit Description(const std::string& path) {
    std::ifstream in(path);
    int count = 0;
    in >> n;
    rows.resize(n);
    bodies.resize(n);
    for (auto& row : rows) for (double& x : row) in >> x;
    for (auto& body : bodies) for (double& x : body) in >> x;
    in >> count;
    leaders.resize(count);
    for (int& k : leaders) in >> k;
    in >> count;
    states.resize(count);
    for (auto& s : states)
      for (auto& part : s) {
        part.resize(n);
        for (double& x : part) in >> x;
      }
    if (!in) throw std::runtime_error("model.txt is incomplete");
  }

  pinocchio::Model model() const {
    pinocchio::Model model;
    model.gravity.linear(Eigen::Vector3d(0, 0, -9.81));
    pinocchio::JointIndex parent = 0;
    for (int i = 0; i < n; ++i) {
      const auto [alpha, d, theta, r] = rows[i];
      const Eigen::Matrix3d twist = Eigen::AngleAxisd(alpha, Eigen::Vector3d::UnitX()).toRotationMatrix();
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(theta, Eigen::Vector3d::UnitZ()).toRotationMatrix();
      const pinocchio::SE3 placement(twist * turn, twist * Eigen::Vector3d(d, 0, r));
      parent = model.addJoint(parent, pinocchio::JointModelRZ(), placement, "joint" + std::to_string(i + 1));
      const auto& b = bodies[i];
      const Eigen::Vector3d c = Eigen::Vector3d(b[1], b[2], b[3]) / b[0];
      Eigen::Matrix3d inertia;
      inertia << b[4], b[7], b[8], b[7], b[5], b[9], b[8], b[9], b[6];
      inertia -= b[0] * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
      model.appendBodyToJoint(parent, pinocchio::Inertia(b[0], c, inertia), pinocchio::SE3::Identity());
    }
    return model;
  }

  // Where our column stands in Pinocchio's regressor: m, mx, my, mz, Ixx, Ixy, Iyy, Ixz, Iyz, Izz.
  static int column(int ours) {
    static const int place[10] = {0, 1, 2, 3, 4, 6, 9, 5, 7, 8};
    return ours / 10 * 10 + place[ours % 10];
  }
};
