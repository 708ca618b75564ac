// Median nanoseconds of a call.
#pragma once
#include <algorithm>
#include <chrono>
#include <vector>

template <class F>
double nanoseconds(F&& call) {
  using clock = std::chrono::steady_clock;
  const auto batch = [&](int calls) {
    const auto start = clock::now();
    for (int i = 0; i < calls; ++i) call();
    return std::chrono::duration<double, std::nano>(clock::now() - start).count();
  };
  int calls = 16;
  while (batch(calls) < 2e5) calls *= 2;
  std::vector<double> samples;
  for (int i = 0; i < 300; ++i) samples.push_back(batch(calls) / calls);
  std::nth_element(samples.begin(), samples.begin() + 150, samples.end());
  return samples[150];
}
