// One run of samples on its way.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "gonio/base/result.h"
#include "server/work/incident_source.h"
#include "server/work/work.h"
#include "wire/codec.h"

namespace gonio::server {

class Sampling final : public Work {
 public:
  using Request = wire::SampleRequest;
  static constexpr const char* kMethod = "Sample";
  static constexpr const char* kStreamMethod = "SampleStream";
  static constexpr const char* kItems = "samples";

  // As Evaluation's.
  static Result<std::shared_ptr<Sampling>> prepare(const Request& request,
                                                   PreparedMaterial material,
                                                   std::size_t max_answer_bytes);

  void run_tile(std::size_t tile) override;
  wire::SampleResponseParts take_answer();

 private:
  Sampling(IncidentSource source, PreparedMaterial material, const Settings& settings)
      : Work(std::move(material), settings, true), source_(std::move(source)) {}
  Outcome choose_run(const Request& request);
  Outcome set_xi(const Request& request);
  Outcome allocate(std::size_t request_bytes, std::size_t max_answer_bytes);
  template <class T>
  void sample_tile(std::size_t first, std::size_t count);

  IncidentSource source_;
  std::optional<NumberArray> xi_;
  std::uint64_t first_ = 0;  // counted from the first sample of the first wi given
  std::uint64_t count_ = 0;
  grpc::Slice wo_, pdf_, weights_, flags_;
  void* wo_data_ = nullptr;
  void* pdf_data_ = nullptr;
  void* weight_data_ = nullptr;
  std::uint8_t* flag_data_ = nullptr;
  std::atomic<std::uint64_t> lost_{0};
};

}  // namespace gonio::server
