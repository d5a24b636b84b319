#include <algorithm>
#include <memory>
#include <utility>

#include "client/calls/state.h"
#include "client/rpc/open_call.h"
#include "client/rpc/progress_call.h"
#include "gonio/client/client.h"
#include "gonio/v1/put.pb.h"
#include "wire/message.h"
#include "wire/sha256.h"

namespace gonio::client {
namespace {

namespace v1 = gonio::v1;

constexpr std::size_t kChunk = std::size_t{256} << 10;

v1::PutMaterialRequest announcement(std::string_view name, std::string_view content,
                                    const wire::Sha256Sum& sum) {
  v1::PutMaterialRequest request;
  request.mutable_file()->set_name(std::string(name));
  request.mutable_file()->set_size(content.size());
  request.mutable_file()->set_sha256(std::string(sum.begin(), sum.end()));
  return request;
}

// One try. Each step waits for its only event.
class PutAttempt {
 public:
  PutAttempt(const Peer& peer, const Patience& patience)
      : call_(new OpenCall(patience, std::make_unique<grpc::CompletionQueue>())) {
    grpc::GenericStub stub(peer.channel);
    call_->stream = stub.PrepareCall(&call_->context, kPutMaterialMethod, call_->queue.get());
  }

  // True once all is sent; false where the server, or the connection, has ended the call before.
  // Errors: stopped by the caller.
  Result<bool> send(const v1::PutMaterialRequest& first, std::string_view content,
                    const PutWatch& watch) {
    call_->stream->StartCall(nullptr);
    if (!happens() || !write(first)) return false;
    for (std::size_t at = 0; at < content.size(); at += kChunk) {
      if (watch.stop && watch.stop())
        return Error{ErrorCode::cancelled, "the upload was cancelled", {}, {}, {}};
      v1::PutMaterialRequest request;
      request.set_chunk(std::string(content.substr(at, kChunk)));
      if (!write(request)) return false;
      const std::size_t sent = std::min(at + kChunk, content.size());
      if (watch.progress)
        watch.progress(static_cast<double>(sent) / static_cast<double>(content.size()));
    }
    call_->stream->WritesDone(nullptr);
    return happens();
  }

  // After send(). The response's bytes are in incoming() where the status is OK.
  grpc::Status finish() {
    call_->stream->Read(&call_->incoming, nullptr);
    happens();
    call_->stream->Finish(&call_->status, nullptr);
    if (happens()) return call_->status;
    return {grpc::StatusCode::DEADLINE_EXCEEDED, "the connection hangs"};
  }

  grpc::ByteBuffer& incoming() { return call_->incoming; }
  grpc::ClientContext& context() { return call_->context; }

 private:
  bool happens() {
    void* tag = nullptr;
    bool ok = false;
    return call_->next(&tag, &ok) && ok;
  }
  bool write(const v1::PutMaterialRequest& request) {
    call_->outgoing = wire::to_buffer(request);
    call_->stream->Write(call_->outgoing, nullptr);
    return happens();
  }

  OpenCallPointer call_;
};

Result<PutReport> report_of(grpc::ByteBuffer& bytes, const std::string& peer) {
  v1::PutMaterialResponse response;
  if (!wire::from_buffer(bytes, response))
    return Error{ErrorCode::internal, peer + " sent an answer that cannot be read", {}, {}, {}};
  PutReport report;
  report.place =
      response.place() == v1::MATERIAL_PLACE_FOLDER ? PutPlace::folder : PutPlace::memory;
  report.cells = response.cells();
  report.invalid_cells = response.invalid_cells();
  report.existed = response.existed();
  return report;
}

}  // namespace

Result<PutReport> Client::put_material(std::string_view name, std::string_view content,
                                       const PutWatch& watch) const {
  const wire::Sha256Sum sum = wire::sha256(content);
  const auto first = announcement(name, content, sum);
  Patience patience(state_->options, watch.deadline);
  for (;;) {
    PutAttempt attempt(state_->peer, patience);
    const auto sent = attempt.send(first, content, watch);
    if (!sent) return sent.error();
    const grpc::Status status = attempt.finish();
    if (status.ok()) {
      auto report = report_of(attempt.incoming(), state_->peer.name);
      if (!report) return report;
      report->sha256 = wire::hexadecimal(sum);
      report->retries = patience.retries();
      return report;
    }
    const Failure failure = failure_of(status, attempt.context(), state_->peer.name);
    if (!patience.pause_to_retry(failure)) return failure.error;
  }
}

}  // namespace gonio::client
