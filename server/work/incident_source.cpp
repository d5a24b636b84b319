#include "server/work/incident_source.h"

#include <algorithm>
#include <type_traits>

#include "wire/convert.h"

namespace gonio::server {
namespace {

// Numbers of samples stay below this, so that sums of two of them do not overflow.
constexpr std::uint64_t kMostSamples = std::uint64_t{1} << 62;

}  // namespace

Result<NumberArray> NumberArray::create(const std::string& field, const wire::SliceBytes& bytes,
                                        const wire::Array& f32, const wire::Array& f64,
                                        Precision precision) {
  if (f32.count > 0 && f64.count > 0) {
    return bad_value(field, "given in float32 and in float64", field + " or " + field + "_f64");
  }
  NumberArray result;
  result.is_f64_ = f64.count > 0;
  if (result.is_f64_ && precision == Precision::fast) {
    return bad_value("precision", "PRECISION_FAST",
                     "PRECISION_REFERENCE for " + field + "_f64, or " + field + " in float32");
  }
  result.array_ = result.is_f64_ ? f64 : f32;
  result.bytes_ = bytes;
  return result;
}

template <class T>
void NumberArray::read(std::size_t first, std::size_t count, T* to) const {
  if (is_f64_ == std::is_same_v<T, double>)
    return bytes_.copy(array_.offset + first * sizeof(T), count * sizeof(T), to);
  constexpr std::size_t kBlock = 768;
  float block[kBlock];
  for (std::size_t done = 0, n = 0; done < count; done += n) {
    n = std::min(kBlock, count - done);
    bytes_.copy(array_.offset + (first + done) * sizeof(float), n * sizeof(float), block);
    std::copy_n(block, n, to + done);
  }
}

template void NumberArray::read(std::size_t, std::size_t, float*) const;
template void NumberArray::read(std::size_t, std::size_t, double*) const;

template <class Request>
Result<IncidentSource> IncidentSource::create(const Request& request, Precision precision,
                                              std::uint64_t least_per_wi) {
  auto wi = NumberArray::create("wi", request.bytes, request.wi, request.wi_f64, precision);
  if (!wi) return wi.error();
  if (wi->size() % 3 != 0) {
    return bad_value("wi", "an array of " + std::to_string(wi->size()) + " numbers",
                     "a multiple of 3: x, y, z of each direction");
  }
  const auto sequence = wire::from_wire(request.head.sequence());
  if (!sequence) return sequence.error();
  IncidentSource source{std::move(*wi),
                        request.head.per_wi(),
                        {*sequence, request.head.seed()},
                        request.head.first_wi()};
  if (source.per_wi < least_per_wi || source.per_wi > kMostSamples) {
    return bad_value("per_wi", std::to_string(source.per_wi),
                     std::to_string(least_per_wi) + " to 2^62 samples of each wi");
  }
  const std::uint64_t most_wi = kMostSamples / source.per_wi;
  if (source.first_wi > most_wi || source.directions() > most_wi - source.first_wi) {
    return bad_value(source.first_wi > 0 ? "first_wi" : "per_wi",
                     std::to_string(source.first_wi > 0 ? source.first_wi : source.per_wi),
                     "at most 2^62 samples, all wi together");
  }
  return source;
}

template Result<IncidentSource> IncidentSource::create(const wire::SampleRequest&, Precision,
                                                       std::uint64_t);
template Result<IncidentSource> IncidentSource::create(const wire::IntegrateRequest&, Precision,
                                                       std::uint64_t);

}  // namespace gonio::server
