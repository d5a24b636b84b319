// A material's sampler as the checks see it: what it draws, and what it says of any direction.
#pragma once

#include <functional>
#include <vector>

#include "gonio/engine/sampler.h"
#include "models/harness/hemisphere.h"

namespace gonio::testing {

// Sample by sample; wo interleaved, weights channel by channel.
template <class T>
struct Samples {
  std::vector<T> wo, pdf, weights;
  std::vector<std::uint8_t> flags;
  std::uint64_t lost = 0;
};

// The same of given directions, with f in the place of the weights.
template <class T>
struct Densities {
  std::vector<T> pdf, f;
};

template <class T>
struct SamplingSubject {
  MaterialSpec spec;
  Sampler sampler;  // the library's, by which the shares of strategies are told
  std::size_t channels = 1;
  // By three numbers a sample.
  std::function<Samples<T>(const Direction& wi, const std::vector<T>& xi)> draw;
  std::function<Densities<T>(const Direction& wi, const std::vector<T>& wo)> evaluate;
};

// The library's, T its precision's type.
template <class T>
SamplingSubject<T> library_sampling(const MaterialSpec& spec, const Sampler& sampler, Isa isa);

Sampler sampler_of(const MaterialSpec& spec);

// The share of samples that each strategy of the library's mixture gets at this incidence: those of
// the specular lobes in order, then that of the cosine, if it is one.
std::vector<double> shares_of(const Sampler& sampler, double cos_i);

// Numbers of Sequence::random for `count` samples, interleaved.
template <class T>
std::vector<T> numbers(std::uint64_t seed, std::size_t count);

}  // namespace gonio::testing
