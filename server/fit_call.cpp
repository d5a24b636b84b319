#include "server/fit_call.h"

#include <grpcpp/impl/codegen/proto_utils.h>
#include <grpcpp/server_context.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "base/happens_before.h"
#include "server/fit_messages.h"
#include "wire/status.h"

namespace gonio {
namespace {

using Clock = std::chrono::system_clock;

constexpr std::chrono::milliseconds kInterval{200};  // of progress

// The core knows the fields of the form, not what a request calls it.
Error within_request(Error error) {
  const bool of_form =
      error.code == ErrorCode::invalid_argument || error.code == ErrorCode::not_found;
  if (!of_form || error.field.rfind("options.", 0) == 0) return error;
  if (error.field == "material") error.field.clear();
  const std::string field = error.field.empty() ? "form" : "form." + error.field;
  if (!error.field.empty() && error.message.rfind(error.field, 0) == 0)
    error.message.replace(0, error.field.size(), field);
  error.field = field;
  return error;
}

grpc::ByteBuffer to_buffer(const v1::FitResponse& response) {
  grpc::ByteBuffer buffer;
  bool own = false;
  grpc::SerializationTraits<v1::FitResponse>::Serialize(response, &buffer, &own);
  return buffer;
}

}  // namespace

FitCall::FitCall(const Backend& backend, grpc::CallbackServerContext& context)
    : backend_(backend),
      context_(context),
      state_(std::min(context.deadline(), Clock::now() + backend.fits.longest)),
      access_("Fit", "pairs", context, backend.logger) {
  progress_.set_stage("queued");
}

FitCall* FitCall::start(const Backend& backend, grpc::CallbackServerContext& context,
                        const grpc::ByteBuffer& request) {
  const std::shared_ptr<FitCall> call(new FitCall(backend, context));
  call->self_ = call;
  happens_before(&call->state_);
  if (const auto queued = call->enqueue(request); !queued) {
    call->end(std::nullopt, wire::to_status(queued.error()));
  } else {
    call->tick();
  }
  return call.get();
}

Outcome FitCall::enqueue(const grpc::ByteBuffer& buffer) {
  auto request = decode_fit_request(buffer);
  if (!request) return request.error();
  request_ = std::move(*request);
  auto task = fit_task(request_, backend_.materials);
  if (!task) return task.error();
  task_ = std::move(*task);
  charge_ = backend_.memory.take(task_.bytes);
  const char* full = charge_ ? "queue of fits is full" : "memory is full";
  if (charge_) {
    auto self = shared_from_this();
    if (backend_.fits.queue.submit(
            {[self] { self->run(); }, [self] { return self->state_.is_over(); }}))
      return Ok{};
  }
  context_.AddTrailingMetadata(wire::kRetryPushback, kFitPushbackMilliseconds);
  return Error{ErrorCode::resource_exhausted,
               std::string("the server's ") + full + ": it takes " +
                   std::to_string(backend_.fits.queue.max_jobs()) +
                   " fits at a time; send this one again after " + kFitPushbackMilliseconds + " ms",
               {},
               {},
               {}};
}

Error FitCall::over() const {
  if (!state_.past_deadline()) return {ErrorCode::cancelled, "the fit was cancelled", {}, {}, {}};
  const auto longest = std::chrono::duration_cast<std::chrono::seconds>(backend_.fits.longest);
  return {ErrorCode::deadline_exceeded,
          "the fit was not done within its deadline; this server gives a fit at most " +
              std::to_string(longest.count()) + " s",
          {},
          {},
          {}};
}

Result<fit::FitResult> FitCall::fit() {
  if (state_.is_over()) return over();
  v1::FitProgress reading;
  reading.set_stage("data");
  note(std::move(reading));
  const auto data = fit_data(request_, task_);
  if (!data) return data.error();
  request_.Clear();
  access_.items = data->size();
  fit::Watch watch;
  watch.progress = [this](const fit::Progress& progress) { note(to_wire(progress)); };
  watch.stop = [this] {
    BackgroundQueue::give_way();
    return state_.is_over();
  };
  auto result = fit::fit(*data, task_.form, task_.options, watch);
  if (result) return result;
  return result.error().code == ErrorCode::cancelled ? over() : within_request(result.error());
}

void FitCall::run() {
  const auto result = fit();
  if (!result) return end(std::nullopt, wire::to_status(result.error()));
  access_.kernel_seconds = result->certificate.cpu_seconds;
  v1::FitResponse response;
  *response.mutable_result() = to_wire(*result);
  end(std::move(response), grpc::Status::OK);
}

void FitCall::note(v1::FitProgress progress) {
  const std::lock_guard lock(mutex_);
  progress_ = std::move(progress);
}

void FitCall::end(std::optional<v1::FitResponse> result, const grpc::Status& status) {
  access_.failed = status.ok() ? 0 : 1;
  access_.write(backend_.logger, status.ok() ? "OK" : status.error_message());
  {
    const std::lock_guard lock(mutex_);
    result_ = std::move(result);
    end_ = status;
  }
  pump(false);
}

// Now, and again and again until the call is over.
void FitCall::tick() {
  {
    const std::lock_guard lock(mutex_);
    if (end_) return;
  }
  pump(true);
  // Weak: the alarm belongs to the call. gRPC calls back after Set(); the name for that is not the
  // call's, which is not known to be there before the lock.
  static const char alarms = 0;
  std::function<void(bool)> again = [weak = weak_from_this()](bool) {
    happens_after(&alarms);
    if (const auto call = weak.lock()) call->tick();
  };
  happens_before(&alarms);
  alarm_.Set(Clock::now() + kInterval, std::move(again));
}

void FitCall::OnWriteDone(bool ok) {
  const Reaction reaction(this, &outgoing_);
  {
    const std::lock_guard lock(mutex_);
    writing_ = false;
  }
  if (!ok) state_.cancel();
  pump(false);
}

void FitCall::OnCancel() {
  const Reaction reaction(this, &state_);
  state_.cancel();
  backend_.fits.queue.drop_over();
}

void FitCall::OnDone() {
  happens_after(this);
  const Backend& backend = backend_;
  self_.reset();
  backend.call_ends();
}

// One write at a time; the result goes with the end.
void FitCall::pump(bool progress_is_due) {
  const auto self = shared_from_this();  // gRPC may be done with the call before this returns
  bool write = false;
  std::optional<grpc::Status> final;
  {
    const std::lock_guard lock(mutex_);
    if (writing_ || finished_) return;
    if (end_) {
      finished_ = true;
      final = end_;
      if (result_) outgoing_ = to_buffer(*result_);
      write = result_.has_value();
    } else if (progress_is_due) {
      v1::FitResponse response;
      *response.mutable_progress() = progress_;
      outgoing_ = to_buffer(response);
      writing_ = write = true;
    }
  }
  happens_before(&outgoing_);
  if (final) happens_before(this);
  if (final && write) return StartWriteAndFinish(&outgoing_, {}, *final);
  if (final) return Finish(*final);
  if (write) StartWrite(&outgoing_);
}

}  // namespace gonio
