// A material of the service as a surface. Thread safety: used by one thread.
#pragma once

#include <span>
#include <vector>

#include "client/picture/render/surface.h"
#include "gonio/base/result.h"
#include "gonio/client/client.h"

namespace gonio::render {

class Evaluator : public Surface {
 public:
  // Has the material checked. Errors: what the service says, and a material of other than 1 or 3
  // channels. The client must outlive it. A material of one channel is grey.
  static Result<Evaluator> create(const client::Client& client, client::Material material);

  Outcome evaluate(std::span<const float> viewers, std::span<const float> lights, std::span<Rgb> f,
                   std::span<float> pdf) override;
  Outcome sample(std::span<const float> viewers, std::span<const float> xi, std::span<float> lights,
                 std::span<float> pdf, std::span<Rgb> weights) override;

  // Of all calls until now.
  [[nodiscard]] const client::Report& report() const { return report_; }
  [[nodiscard]] int channels() const { return channels_; }

 private:
  Evaluator(const client::Client& client, client::Material material, int channels)
      : client_(&client), material_(std::move(material)), channels_(channels) {}
  void take_colours(std::span<Rgb> colours) const;

  const client::Client* client_;
  client::Material material_;
  int channels_;
  std::vector<float> values_;
  client::Report report_;
};

}  // namespace gonio::render
