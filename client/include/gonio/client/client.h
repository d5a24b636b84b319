// The gonio client: evaluates and samples materials on a server. This is the header to read first.
//
//   auto client = gonio::client::Client::connect("localhost:50051");
//   auto gold = gonio::client::Material::from_json(
//       R"({"model": "ggx", "parameters": {"f0": [1, 0.71, 0.29]}})");
//   std::vector<float> wi = {0, 0, 1}, wo = {0.6f, 0, 0.8f}, values(3);
//   auto report = client->evaluate(*gold, wi, wo, values);
//   if (!report) std::puts(report.error().message.c_str());
//
// Directions live in the local shading frame: normal (0,0,1), tangents u = (1,0,0) and v = (0,1,0);
// `wi` points to the light and `wo` to the viewer, both away from the surface; interleaved xyz,
// three numbers per pair. They may be off unit length by 1e-3 (it is corrected). Values are f(wi,
// wo) in 1/sr without a cosine, interleaved: all channels of the first pair, then of the second. A
// pair that cannot be evaluated gets the value 0 and a flag (see gonio/client/types.h); its
// neighbours are not affected. What comes back depends on nothing but pair, material, precision and
// instruction set.
//
// Sampling draws directions wo for a wi, with densities and weights: see gonio/client/sampling.h.
//
// Up to `chunk_pairs` pairs (or samples) travel as one call; more as a stream of chunks, several of
// them in flight. What a server refuses for the moment, or loses because it goes down, is sent
// again, a bounded number of times and within the deadline: nothing changes on the server and every
// answer can be repeated.
//
// Errors are values (base/result.h) and name the field or the server's address. Where one comes
// back, the contents of the caller's arrays are unspecified. Thread safety: one Client may be used
// from many threads at once.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "gonio/base/result.h"
#include "gonio/client/assess.h"
#include "gonio/client/chart.h"
#include "gonio/client/fit.h"
#include "gonio/client/grid.h"
#include "gonio/client/material.h"
#include "gonio/client/models.h"
#include "gonio/client/options.h"
#include "gonio/client/pair_chunks.h"
#include "gonio/client/put.h"
#include "gonio/client/sampling.h"
#include "gonio/client/select.h"
#include "gonio/client/types.h"

namespace grpc {
class Channel;
}

namespace gonio::client {

class Client {
 public:
  // For "host:port", "[::1]:port" or "unix:/path". Nothing is sent yet: a server that is not there
  // shows at the first call. Errors: options that make no sense.
  static Result<Client> connect(const std::string& address, const ClientOptions& options = {});
  // Over a channel of the caller's own making (TLS, a balancing policy, in-process). `name` is what
  // errors call the server.
  static Result<Client> from_channel(std::shared_ptr<grpc::Channel> channel, std::string name,
                                     const ClientOptions& options = {});

  ~Client();
  Client(Client&&) noexcept;
  Client& operator=(Client&&) noexcept;

  // The models, or the one called `name`. Errors: not_found.
  [[nodiscard]] Result<Catalogue> list_models(std::string_view name = {}) const;
  // The same answer as JSON: gonio.v1.ListModelsResponse, its fields named as in the .proto.
  [[nodiscard]] Result<std::string> list_models_json(std::string_view name = {}) const;

  // How many values a pair has, which is also the cheapest way to have a material checked.
  [[nodiscard]] Result<int> channels(const Material& material) const;

  // Evaluates wi.size() / 3 pairs. float values are Precision::fast, double values
  // Precision::reference. `values` holds pairs x channels numbers; `flags` one byte a pair, or
  // nothing. Errors: lengths that do not fit (before anything is sent, or, for a wrong number of
  // channels, with the first answer), and what the server says.
  Result<Report> evaluate(const Material& material, std::span<const float> wi,
                          std::span<const float> wo, std::span<float> values,
                          std::span<std::uint8_t> flags = {},
                          const EvaluateOptions& options = {}) const;
  Result<Report> evaluate(const Material& material, std::span<const float> wi,
                          std::span<const float> wo, std::span<double> values,
                          std::span<std::uint8_t> flags = {},
                          const EvaluateOptions& options = {}) const;
  Result<Report> evaluate(const Material& material, std::span<const double> wi,
                          std::span<const double> wo, std::span<double> values,
                          std::span<std::uint8_t> flags = {},
                          const EvaluateOptions& options = {}) const;

  // The same, and the density per steradian with which sample() draws wo for wi: one a pair, 0 for
  // a flagged one. The values are evaluate()'s, bit for bit.
  Result<Report> evaluate_with_pdf(const Material& material, std::span<const float> wi,
                                   std::span<const float> wo, std::span<float> values,
                                   std::span<float> pdf, std::span<std::uint8_t> flags = {},
                                   const EvaluateOptions& options = {}) const;
  Result<Report> evaluate_with_pdf(const Material& material, std::span<const double> wi,
                                   std::span<const double> wo, std::span<double> values,
                                   std::span<double> pdf, std::span<std::uint8_t> flags = {},
                                   const EvaluateOptions& options = {}) const;

  // The same as evaluate() for the grid.size() pairs of a grid, in its order.
  Result<Report> evaluate(const Material& material, const Grid& grid, std::span<float> values,
                          std::span<std::uint8_t> flags = {},
                          const EvaluateOptions& options = {}) const;
  Result<Report> evaluate(const Material& material, const Grid& grid, std::span<double> values,
                          std::span<std::uint8_t> flags = {},
                          const EvaluateOptions& options = {}) const;

  // Any number of pairs in little memory: from a source, to a sink. In/Out: float/float,
  // float/double or double/double.
  template <class In, class Out>
  Result<Report> evaluate_chunks(const Material& material, const PairSource<In>& source,
                                 const ChunkSink<In, Out>& sink,
                                 const EvaluateOptions& options = {}) const;
  // Out: float or double.
  template <class Out>
  Result<Report> evaluate_chunks(const Material& material, const Grid& grid,
                                 const ChunkSink<Out, Out>& sink,
                                 const EvaluateOptions& options = {}) const;

  // Draws samples batch.first ... batch.first + results.pdf.size() - 1 of batch.wi.size() / 3 x
  // batch.per_wi. Errors: lengths that do not fit, and what the server says.
  Result<Report> sample(const Material& material, const SampleBatch<float>& batch,
                        const Samples<float>& results, const EvaluateOptions& options = {}) const;
  Result<Report> sample(const Material& material, const SampleBatch<double>& batch,
                        const Samples<double>& results, const EvaluateOptions& options = {}) const;

  // per_wi samples of any number of wi in little memory: from a source, to a sink. T: float or
  // double.
  template <class T>
  Result<Report> sample_chunks(const Material& material, const DirectionSource<T>& source,
                               std::uint64_t per_wi, const NumberSource& numbers,
                               const SampleSink<T>& sink,
                               const EvaluateOptions& options = {}) const;

  // The albedo for each of wi.size() / 3 directions, by per_wi >= 2 samples of each; sums and
  // squares are formed in float64. float wi ask for Precision::fast, double wi for
  // Precision::reference.
  Result<Albedos> integrate(const Material& material, std::span<const float> wi,
                            std::uint64_t per_wi, const NumberSource& numbers = {},
                            const EvaluateOptions& options = {}) const;
  Result<Albedos> integrate(const Material& material, std::span<const double> wi,
                            std::uint64_t per_wi, const NumberSource& numbers = {},
                            const EvaluateOptions& options = {}) const;

  // Fits what `form` names (models and words; numbers in it are a first guess) to measured
  // reflectance: see client/fit.h. The data travel as one message: up to some 1.5 million pairs of
  // three channels with goniod's default limit. The same data, options and processor give the same
  // result, so that a fit that a failing connection lost is begun again. Errors: `cancelled` if
  // `watch` stops it (within 0.2 s, on the server too), deadline_exceeded, and what the server
  // says. Data that say nothing are no error: the verdict is then `failed`, with the reason.
  Result<FitResult> fit(const FitData& data, const Material& form, const FitOptions& options = {},
                        const FitWatch& watch = {}) const;

  // Stores a measured material, the content of a MERL `.binary` file, on the server under `name`
  // (1 to 100 letters, digits, '-' and '_'), by which it can then be evaluated, sampled and fitted.
  // It is there as a whole or not at all, and never replaced: to put the same bytes again under
  // their name is no error and changes nothing, so that an upload that a failing connection lost is
  // begun again. Errors: invalid_argument for a bad name, already_exists for one that is taken,
  // resource_exhausted for more than the server keeps, data_loss for what is no such file or came
  // damaged; `cancelled` if the watch stops it.
  Result<PutReport> put_material(std::string_view name, std::string_view content,
                                 const PutWatch& watch = {}) const;

  // Runs the material through the places where methods fail: see client/assess.h. Takes about a
  // second. A bad verdict is no error. Errors: limits out of bounds, and what the server says.
  [[nodiscard]] Result<Assessment> assess(const Material& material,
                                          const AssessOptions& options = {}) const;

  // Chooses the cheapest material that is good enough for a scene: see client/select.h. Takes
  // seconds. That nothing is good enough is no error. The same reference, scene and options give
  // the same choice, but for costs that the server measures. Errors: those of fit(), naming
  // "scene....", "options....", "material....", "pairs...." or "reference".
  Result<Selection> select(const SelectReference& reference, const SelectScene& scene,
                           const SelectOptions& options = {}, const SelectWatch& watch = {}) const;

  // Measures speed against accuracy on the server's machine: see client/chart.h. Takes about a
  // minute; what else the server does meanwhile shows in the times. Errors: "parts[1]",
  // "repetitions" and other options out of bounds, those of fit() for the data, and what the server
  // says.
  [[nodiscard]] Result<Chart> chart(const ChartOptions& options = {},
                                    const ChartWatch& watch = {}) const;

 private:
  struct State;
  explicit Client(std::unique_ptr<const State> state);
  std::unique_ptr<const State> state_;
};

}  // namespace gonio::client
