#include "load/client.h"

#include <algorithm>
#include <cmath>

namespace cutaway::load {

namespace asio = boost::asio;
using boost::system::error_code;

namespace {

constexpr double kGoldenRatio = 0.6180339887498949;

// Spreads the clients evenly over the loop, however many there are.
double entry_of(int index) {
  double whole = 0.0;
  return std::modf(index * kGoldenRatio, &whole);
}

std::string words_of(const Json& error) {
  std::string text = error.value("code", "") + ": " + error.value("message", "");
  for (const char* part : {"field", "expected", "received"}) {
    if (error.contains(part)) text += std::string(", ") + part + " " + error.value(part, "");
  }
  return text;
}

// Throws std::runtime_error where the server has no style of that name.
Json style_scene(const Json& capabilities, const std::string& name) {
  std::string names;
  for (const Json& style : capabilities.at("styles")) {
    if (style.at("name") == name) return style.at("scene");
    names += (names.empty() ? "" : ", ") + style.at("name").get<std::string>();
  }
  throw std::runtime_error("style: expected one of " + names + "; came \"" + name + "\"");
}

}  // namespace

Client::Client(const asio::any_io_executor& executor, const RunPlan& plan, LiveCounters& counters,
               int index, int role)
    : executor_(executor),
      plan_(plan),
      counters_(counters),
      index_(index),
      record_{.role = role},
      ledger_(record_),
      connection_(std::make_shared<Connection>(executor, this->role().link)),
      motion_timer_(executor),
      end_timer_(executor) {}

asio::awaitable<void> Client::run(double start_s) {
  const auto self = shared_from_this();
  co_await wait_until(motion_timer_, start_s);
  asio::co_spawn(
      executor_, [self] { return self->say_goodbye(); }, asio::detached);
  std::string reason;
  try {
    co_await serve();
    reason = connection_->end_reason();
  } catch (const std::exception& failure) {
    reason = failure.what();
  }
  if (!saying_goodbye_) lost(reason);
  end_timer_.cancel();
  motion_timer_.cancel();
  connection_->close();
  ++counters_.ended;
}

asio::awaitable<void> Client::serve() {
  co_await connection_->open(plan_.address);
  ++counters_.connected;
  std::optional<Arrival> arrival = co_await connection_->receive();
  while (arrival) {
    take(*arrival);
    arrival = co_await connection_->receive();
  }
}

asio::awaitable<void> Client::say_goodbye() {
  const auto self = shared_from_this();
  co_await wait_until(end_timer_, plan_.end_s);
  saying_goodbye_ = true;
  motion_timer_.cancel();
  connection_->close();
}

asio::awaitable<void> Client::wait_until(asio::steady_timer& timer, double at_s) {
  timer.expires_at(plan_.clock.at(at_s));
  error_code woken;
  co_await timer.async_wait(asio::redirect_error(asio::use_awaitable, woken));
}

void Client::take(const Arrival& arrival) {
  counters_.bytes += arrival.content.size();
  try {
    if (!arrival.text) return take_frame(arrival.content);
    record_.text_bytes += arrival.content.size();
    take_text(Json::parse(arrival.content));
  } catch (const BrokenFrame& broken) {
    note_error(broken.what());
  } catch (const Json::exception& broken) {
    note_error(std::string("a message that does not follow the protocol: ") + broken.what());
  }
}

void Client::take_text(const Json& message) {
  const std::string type = message.at("type");
  if (type == "capabilities") begin(message);
  if (type == "scene" && !walk_) scene_is_open(message.at("scene"));
  if (type == "error") note_error(words_of(message));
}

void Client::begin(const Json& capabilities) {
  record_.server = capabilities.value("server", "");
  record_.renderer = capabilities.value("renderer", "");
  Json scene = style_scene(capabilities, plan_.script.style);
  scene.merge_patch(plan_.script.scene);
  scene["volume"] = plan_.script.volume;
  record_.first_message_s = plan_.clock.now_s();
  send_input({{"type", "viewport"},
              {"width_px", role().viewport.width_px},
              {"height_px", role().viewport.height_px}});
  send_input({{"type", "scene"}, {"scene", scene}});
}

void Client::scene_is_open(const Json& scene) {
  walk_.emplace(role(), CameraPath(scene.at("camera")), static_cast<std::uint32_t>(index_),
                entry_of(index_));
  if (const auto& stop = role().reading) {
    const double from_s = plan_.clock.now_s() + stop->stops_after_s;
    connection_->stop_reading(plan_.clock.at(from_s), plan_.clock.at(from_s + stop->for_s));
  }
  const auto self = shared_from_this();
  asio::co_spawn(
      executor_, [self] { return self->move_all(); }, asio::detached);
}

// A step that is late is sent at once: a client that cannot keep up shows in the lag, not in
// fewer inputs.
asio::awaitable<void> Client::move_all() {
  const auto self = shared_from_this();
  const double begin_s = plan_.clock.now_s();
  std::optional<Step> step = walk_->next();
  while (step && !saying_goodbye_) {
    const double due_s = begin_s + step->at_s;
    co_await wait_until(motion_timer_, due_s);
    const double now_s = plan_.clock.now_s();
    if (saying_goodbye_ || now_s < due_s) co_return;
    record_.input_lag_ms.push_back(static_cast<float>(1e3 * (now_s - due_s)));
    const std::uint32_t input = send_input(std::move(step->message));
    ledger_.moved(now_s, walk_->pause_s());
    step = walk_->next();
    if (!step || begin_s + step->at_s > due_s + walk_->pause_s()) ledger_.rested(input, now_s);
  }
}

std::uint32_t Client::send_input(Json message) {
  message["input"] = ++inputs_;
  message["clock_ms"] = 1e3 * plan_.clock.now_s();
  connection_->send(message.dump());
  return inputs_;
}

// Acknowledged at once: what the link costs lies behind the frame, and ahead of the answer.
void Client::take_frame(const std::string& message) {
  const FrameHeader frame = parse_frame_header(message);
  if (frame.type != FrameHeader::Type::live) return;
  if (!record_.first_frame_s) ++counters_.showing;
  const std::uint64_t stale = record_.stale_frames;
  ledger_.arrived(frame, message.size(), plan_.clock.now_s());
  counters_.stale += record_.stale_frames - stale;
  ++counters_.frames;
  connection_->send(Json{{"type", "ack"}, {"frame", frame.number}}.dump());
}

void Client::note_error(const std::string& text) {
  record_.note_error(text);
  ++counters_.errors;
}

void Client::lost(const std::string& reason) {
  record_.disconnected = true;
  record_.disconnect_reason = reason.empty() ? "the connection ended" : reason;
}

}  // namespace cutaway::load
