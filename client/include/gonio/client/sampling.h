// What is given to have directions drawn, and what comes back: see Client::sample.
//
// A sample is a direction wo drawn for a wi, with the density (per steradian) it was drawn with and
// a weight f cos(theta_o) / pdf in every channel; a mean of weights is an albedo. A sample that
// falls to or below the horizon is lost: weight and pdf 0, flag outgoing_below_horizon. It counts.
//
// Samples are numbered, wi by wi, from 0. Each depends on its wi, the material, precision,
// instruction set and its three numbers in [0, 1) alone; and those, unless the caller gives them,
// are functions of a seed and the sample's number. Any run of samples can be asked for again and is
// the same bit for bit. Thread safety: plain values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "gonio/base/result.h"
#include "gonio/client/types.h"

namespace gonio::client {

enum class Sequence : std::uint8_t {
  random,  // independent: Philox4x32-10, Salmon et al. 2011
  sobol,   // evenly spread for each wi: Owen-scrambled Sobol', Burley 2020; best in powers of two,
           // repeats after 2^32
};

struct NumberSource {
  Sequence sequence = Sequence::random;
  std::uint64_t seed = 0;
};

// T: float is Precision::fast, double is Precision::reference.
template <class T>
struct SampleBatch {
  std::span<const T> wi;     // interleaved xyz
  std::uint64_t per_wi = 1;  // samples of each
  NumberSource numbers;
  // In place of `numbers`: three numbers for each sample that is drawn. A sample with one outside
  // [0, 1) is flagged.
  std::span<const T> xi;
  // The run of samples to draw begins with this one; its length is that of the results.
  std::uint64_t first = 0;
};

// Where the samples go; all but `flags` must be given.
template <class T>
struct Samples {
  std::span<T> wo;                // interleaved xyz; (0,0,0) where wi or xi is bad
  std::span<T> pdf;               // one a sample
  std::span<T> weights;           // samples x channels
  std::span<std::uint8_t> flags;  // one byte a sample, or nothing
};

// Gives the next wi: writes n <= wi.size() / 3 of them to the front and returns n; 0 ends the
// input. Called on the thread that called sample_chunks; an error ends it and is passed on.
template <class T>
using DirectionSource = std::function<Result<std::size_t>(std::span<T> wi)>;

// A run of samples. All of it is valid during the call of the sink only.
template <class T>
struct SampleChunk {
  std::uint64_t first = 0;  // the number of its first sample
  std::size_t samples = 0;
  std::uint64_t per_wi = 1;
  int channels = 0;
  std::span<const T> wi;  // those of the samples, beginning with the first one's
  std::span<const T> wo, pdf, weights;
  std::span<const std::uint8_t> flags;

  // The wi of sample i of this chunk.
  [[nodiscard]] std::span<const T, 3> wi_of(std::size_t i) const {
    return wi.subspan(static_cast<std::size_t>(3 * ((first % per_wi + i) / per_wi)))
        .template first<3>();
  }
};

// Takes the samples in their order, on the thread that called; an error ends the drawing and is
// passed on.
template <class T>
using SampleSink = std::function<Outcome(const SampleChunk<T>&)>;

// The albedo (directional-hemispherical reflectance) for each wi, by sampling.
struct Albedos {
  Report report;               // pairs: samples, of all wi together
  std::vector<double> albedo;  // of each wi, all channels
  // Of each albedo. An upper estimate for Sequence::sobol: it takes the samples to be independent.
  std::vector<double> standard_error;
  std::vector<double> lost;  // of each wi: the fraction of samples below the horizon
  // Of each wi: the part of the hemisphere, weighed by cos(theta_o), whose values a table has not
  // measured (flag::hole, flag::outside_data); 0 of other materials.
  std::vector<double> holes;
  std::vector<std::uint8_t> flags;  // of each wi
};

}  // namespace gonio::client
