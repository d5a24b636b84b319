#include "server/work/integration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "engine/material/hole_share.h"

namespace gonio::server {
namespace {

// What an integration has no use for goes here.
template <class T>
struct Drawn {
  T wi[3];
  std::vector<T> wo, pdf, weights;
  std::vector<std::uint8_t> flags;

  Drawn(std::size_t samples, std::size_t channels)
      : wo(3 * samples), pdf(samples), weights(samples * channels), flags(samples) {}
};

}  // namespace

Result<std::shared_ptr<Integration>> Integration::prepare(const Request& request,
                                                          PreparedMaterial material,
                                                          std::size_t max_answer_bytes) {
  const auto settings = settings_of(request.head);
  if (!settings) return settings.error();
  auto source = IncidentSource::create(request, settings->precision, 2);
  if (!source) return source.error();
  if (source->samples() > kMostSamples) {
    return bad_value("per_wi", std::to_string(source->per_wi),
                     "at most " + std::to_string(kMostSamples) + " samples, all wi together");
  }
  std::shared_ptr<Integration> integration(
      new Integration(std::move(*source), std::move(material), *settings));
  const auto allocated = integration->allocate(request.bytes.size(), max_answer_bytes);
  if (!allocated) return allocated.error();
  return integration;
}

Outcome Integration::allocate(std::size_t request_bytes, std::size_t max_answer_bytes) {
  blocks_ = static_cast<std::size_t>((source_.per_wi + kBlock - 1) / kBlock);
  const std::size_t per_wi = blocks_ * (channels() * sizeof(Moments) + sizeof(Block));
  const std::size_t most = (max_answer_bytes - std::min(max_answer_bytes, kHeadBytes)) / per_wi;
  if (source_.directions() > most) {
    return bad_value("wi", std::to_string(source_.directions()) + " directions",
                     "at most " + std::to_string(most) + " directions of so many samples (" +
                         std::to_string(channels()) +
                         " channels); ask for the rest in further requests");
  }
  set_size(static_cast<std::size_t>(source_.samples()),
           request_bytes + source_.directions() * per_wi);
  done_.resize(tiles());
  moments_.resize(tiles() * channels());
  if (has_table(material())) holes_.resize(source_.directions());
  return Ok{};
}

std::uint64_t Integration::block_samples(std::size_t block) const {
  return std::min<std::uint64_t>(kBlock, source_.per_wi - std::uint64_t{block} * kBlock);
}

template <class T>
void Integration::integrate_block(const Sampler& from, std::size_t wi, std::size_t block) {
  const std::uint64_t samples = block_samples(block);
  Drawn<T> drawn(static_cast<std::size_t>(std::min<std::uint64_t>(kRun, samples)), channels());
  source_.wi.read(3 * wi, 3, drawn.wi);
  Block& done = done_[wi * blocks_ + block];
  Moments* moments = &moments_[(wi * blocks_ + block) * channels()];
  SampleBatch<T> batch;
  batch.wi = Directions<T>::interleaved(drawn.wi);
  batch.per_wi = source_.per_wi;
  batch.numbers = source_.numbers;
  batch.wo = drawn.wo.data();
  batch.pdf = drawn.pdf.data();
  batch.weights = Values<T>::interleaved(drawn.weights.data(), material().channels());
  batch.flags = drawn.flags.data();
  for (std::uint64_t begin = 0; begin < samples; begin += batch.count) {
    batch.first = (source_.first_wi + wi) * source_.per_wi + std::uint64_t{block} * kBlock + begin;
    batch.count = static_cast<std::size_t>(std::min<std::uint64_t>(kRun, samples - begin));
    const SampleReport report = sample(from, batch, settings().isa);
    done.lost += report.lost;
    for (std::size_t c = 0; c < channels(); ++c) {
      moments[c].merge(begin, Moments::of(&drawn.weights[c], channels(), batch.count), batch.count);
    }
  }
  // All samples of a bad wi have its flags, and no other.
  if (done.lost < samples) {
    done.flags = static_cast<std::uint8_t>(drawn.flags[0] & ~flag::outgoing_below_horizon);
  }
}

void Integration::find_holes(std::size_t wi) {
  std::array<double, 3> direction{};
  if (settings().precision == Precision::fast) {
    std::array<float, 3> given{};
    source_.wi.read(3 * wi, 3, given.data());
    std::ranges::copy(given, direction.begin());
  } else {
    source_.wi.read(3 * wi, 3, direction.data());
  }
  holes_[wi] = hole_share(material(), direction, settings().isa);
}

void Integration::run_tile(std::size_t tile) {
  const std::size_t wi = tile / blocks_, block = tile % blocks_;
  const Sampler& from = sampler();  // made before the clock runs
  if (block == 0 && !holes_.empty()) find_holes(wi);
  run_timed([&] {
    settings().precision == Precision::fast ? integrate_block<float>(from, wi, block)
                                            : integrate_block<double>(from, wi, block);
    return done_[tile].flags;
  });
}

void Integration::add_answer(std::size_t wi, v1::IntegrateResponse& answer) const {
  const auto n = static_cast<double>(source_.per_wi);
  std::uint64_t lost = 0;
  for (std::size_t block = 0; block < blocks_; ++block) lost += done_[wi * blocks_ + block].lost;
  answer.add_lost(static_cast<double>(lost) / n);
  if (!holes_.empty()) answer.add_holes(holes_[wi]);
  for (std::size_t c = 0; c < channels(); ++c) {
    Moments all;
    for (std::size_t block = 0; block < blocks_; ++block) {
      all.merge(std::uint64_t{block} * kBlock, moments_[(wi * blocks_ + block) * channels() + c],
                block_samples(block));
    }
    answer.add_albedo(all.mean);
    answer.add_standard_error(std::sqrt(all.squares / (n - 1) / n));
  }
}

v1::IntegrateResponse Integration::take_answer() const {
  v1::IntegrateResponse answer;
  answer.set_channels(static_cast<std::uint32_t>(channels()));
  write(*answer.mutable_report());
  for (std::size_t wi = 0; wi < source_.directions(); ++wi) {
    add_answer(wi, answer);
    if (any_flagged())
      answer.mutable_flags()->push_back(static_cast<char>(done_[wi * blocks_].flags));
  }
  return answer;
}

}  // namespace gonio::server
