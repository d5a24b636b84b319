// Albedos on their way: the mean weights of many samples, of which none is kept.
//
// The samples of each wi are cut into blocks of a fixed length whose moments are merged in their
// order, so that the albedo's bits do not depend on threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "gonio/base/result.h"
#include "server/work/incident_source.h"
#include "server/work/moments.h"
#include "server/work/work.h"
#include "wire/codec.h"

namespace gonio::server {

class Integration final : public Work {
 public:
  using Request = wire::IntegrateRequest;
  static constexpr const char* kMethod = "Integrate";
  static constexpr const char* kItems = "samples";

  // Samples of one request: a minute's work.
  static constexpr std::uint64_t kMostSamples = std::uint64_t{1} << 32;

  // As Evaluation's; what is summed up on the way counts as the answer does.
  static Result<std::shared_ptr<Integration>> prepare(const Request& request,
                                                      PreparedMaterial material,
                                                      std::size_t max_answer_bytes);

  [[nodiscard]] std::size_t tiles() const override { return source_.directions() * blocks_; }
  void run_tile(std::size_t tile) override;
  [[nodiscard]] v1::IntegrateResponse take_answer() const;

 private:
  // Samples of a block: some milliseconds, after which a call that is over is left.
  static constexpr std::size_t kBlock = 65536;
  static constexpr std::size_t kRun = 512;  // samples whose weights are held at a time

  struct Block {
    std::uint64_t lost = 0;
    std::uint8_t flags = 0;  // of a bad wi
  };

  Integration(IncidentSource source, PreparedMaterial material, const Settings& settings)
      : Work(std::move(material), settings, true), source_(std::move(source)) {}
  Outcome allocate(std::size_t request_bytes, std::size_t max_answer_bytes);
  [[nodiscard]] std::uint64_t block_samples(std::size_t block) const;
  template <class T>
  void integrate_block(const Sampler& from, std::size_t wi, std::size_t block);
  void find_holes(std::size_t wi);
  void add_answer(std::size_t wi, v1::IntegrateResponse& answer) const;

  IncidentSource source_;
  std::size_t blocks_ = 0;  // of each wi
  std::vector<Block> done_;
  std::vector<double> holes_;     // of each wi, of a table only
  std::vector<Moments> moments_;  // of each block, all channels
};

}  // namespace gonio::server
