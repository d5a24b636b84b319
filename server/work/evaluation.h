// One batch of pairs on its way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "gonio/base/result.h"
#include "server/work/direction_source.h"
#include "server/work/work.h"
#include "wire/codec.h"

namespace gonio::server {

class Evaluation final : public Work {
 public:
  using Request = wire::Request;
  static constexpr const char* kMethod = "Evaluate";
  static constexpr const char* kStreamMethod = "EvaluateStream";
  static constexpr const char* kItems = "pairs";

  // Checks the request (but for its material, given ready) and allocates the answer. Errors name
  // field, value and what is allowed; an answer larger than `max_answer_bytes` is refused before
  // anything is allocated.
  static Result<std::shared_ptr<Evaluation>> prepare(const Request& request,
                                                     PreparedMaterial material,
                                                     std::size_t max_answer_bytes);

  void run_tile(std::size_t tile) override;
  wire::ResponseParts take_answer();

 private:
  Evaluation(DirectionSource source, PreparedMaterial material, const Settings& settings,
             bool with_pdf)
      : Work(std::move(material), settings, with_pdf),
        source_(std::move(source)),
        with_pdf_(with_pdf) {}
  Outcome allocate(std::size_t request_bytes, std::size_t max_answer_bytes);
  template <class In, class Out>
  void evaluate_tile(std::size_t first, std::size_t count);

  DirectionSource source_;
  bool with_pdf_;
  grpc::Slice values_, flags_, pdf_;
  void* value_data_ = nullptr;
  void* pdf_data_ = nullptr;
  std::uint8_t* flag_data_ = nullptr;
};

}  // namespace gonio::server
