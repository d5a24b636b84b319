// A material's colours, asked of the service. Thread safety: used by one thread.
#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "client/client.h"
#include "client/image/image.h"

namespace gonio::render {

class Evaluator {
 public:
  // Has the material checked. Errors: what the service says, and a material of other than 1 or 3
  // channels. The client must outlive it.
  static Result<Evaluator> create(const client::Client& client, client::Material material);

  // f(wi, wo) in 1/sr of interleaved local directions, at most a few 100,000 pairs in a call; a
  // material of one channel is grey. A pair that cannot be evaluated is black.
  Outcome evaluate(std::span<const float> wi, std::span<const float> wo,
                   std::span<image::Rgb> values);

  // Of all calls until now.
  [[nodiscard]] const client::Report& report() const { return report_; }
  [[nodiscard]] int channels() const { return channels_; }

 private:
  Evaluator(const client::Client& client, client::Material material, int channels)
      : client_(&client), material_(std::move(material)), channels_(channels) {}

  const client::Client* client_;
  client::Material material_;
  int channels_;
  std::vector<float> values_;
  client::Report report_;
};

}  // namespace gonio::render
