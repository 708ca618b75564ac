// Values and times of CasADi's compiled C. Usage: casadi_time model.txt kernels.so > result.json
#include <cstdio>
#include <dlfcn.h>

#include "model.hpp"
#include "timing.hpp"

using Function = int (*)(const double**, double**, long long*, double*, int);
using Work = int (*)(long long*, long long*, long long*, long long*);

int main(int, char** argv) {
  const Description description(argv[1]);
  void* library = dlopen(argv[2], RTLD_NOW);
  if (!library) throw std::runtime_error(dlerror());
  const int n = description.n;
  const struct { const char* name; int size; } functions[] = {
      {"regressor", 10 * n * n}, {"base_regressor", n * int(description.leaders.size())}, {"inverse_dynamics", n}, {"mass_matrix", n * n},
      {"gravity", n}, {"jacobian", 6 * n}, {"forward_kinematics", 16}};
  std::string states, times;
  std::vector<std::string> said(description.states.size());
  for (const auto& f : functions) {
    const auto run = reinterpret_cast<Function>(dlsym(library, f.name));
    const auto need = reinterpret_cast<Work>(dlsym(library, (std::string(f.name) + "_work").c_str()));
    long long sizes[4] = {0, 0, 0, 0};
    need(&sizes[0], &sizes[1], &sizes[2], &sizes[3]);
    std::vector<long long> iw(sizes[2] + 1);
    std::vector<double> w(sizes[3] + 1), out(f.size);
    std::vector<double*> res(sizes[1] + 1, nullptr);
    std::vector<const double*> arg(sizes[0] + 3, nullptr);
    char number[32];
    const auto call = [&](size_t s) {
      for (int k = 0; k < 3; ++k) arg[k] = description.states[s][k].data();
      res[0] = out.data();
      run(arg.data(), res.data(), iw.data(), w.data(), 0);
    };
    for (size_t s = 0; s < said.size(); ++s) {
      call(s);
      said[s] += (said[s].empty() ? "\"" : ",\"") + std::string(f.name) + "\":[";
      for (int i = 0; i < f.size; ++i) {
        std::snprintf(number, sizeof number, "%s%.17g", i ? "," : "", out[i]);
        said[s] += number;
      }
      said[s] += "]";
    }
    std::snprintf(number, sizeof number, "%.1f", nanoseconds([&] { call(0); }));
    times += (times.empty() ? "\"" : ",\"") + std::string(f.name) + "\":" + number;
  }
  for (const auto& s : said) states += (states.empty() ? "{" : ",{") + s + "}";
  std::printf("{\"states\":[%s],\"ns\":{%s}}\n", states.c_str(), times.c_str());
}
