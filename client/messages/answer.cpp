#include "client/messages/answer.h"

#include <utility>

#include "client/rpc/rpc.h"

namespace gonio::client {
namespace {

std::uint64_t lost_of(const gonio::v1::EvaluateResponse& /*head*/) { return 0; }
std::uint64_t lost_of(const gonio::v1::SampleResponse& head) { return head.lost(); }

template <class Response>
Answer answer_of(Response response) {
  Answer answer;
  answer.channels = response.head.channels();
  answer.report = std::move(*response.head.mutable_report());
  answer.lost = lost_of(response.head);
  answer.bytes = std::move(response.bytes);
  answer.flags = response.flags;
  answer.values = response.values;
  answer.pdf = response.pdf;
  answer.wo = response.wo;
  answer.is_f64 = response.is_f64;
  return answer;
}

template <class Response>
Result<Answer> decode_call(const grpc::ByteBuffer& message) {
  auto response = wire::decode<Response>(message);
  if (!response) return response.error();
  return answer_of(std::move(*response));
}

template <class Response>
Result<StreamAnswer> decode_chunk(const grpc::ByteBuffer& message) {
  auto chunk = wire::decode<wire::ChunkAnswerOf<Response>>(message);
  if (!chunk) return chunk.error();
  StreamAnswer answer{chunk->sequence, {}};
  if (auto* response = std::get_if<Response>(&chunk->result)) {
    answer.result = answer_of(std::move(*response));
  } else {
    answer.result = std::get<gonio::v1::ErrorDetail>(std::move(chunk->result));
  }
  return answer;
}

}  // namespace

const Method kEvaluate = {kEvaluateMethod, kEvaluateStreamMethod, decode_call<wire::Response>,
                          decode_chunk<wire::Response>};
const Method kSample = {kSampleMethod, kSampleStreamMethod, decode_call<wire::SampleResponse>,
                        decode_chunk<wire::SampleResponse>};

}  // namespace gonio::client
