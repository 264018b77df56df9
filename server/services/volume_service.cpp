#include "services/volume_service.h"

#include <utility>

#include "core/log.h"
#include "core/machine_memory.h"
#include "render/scene_preparation.h"
#include "render/texture_limit.h"
#include "services/client_words.h"
#include "services/load_job.h"

namespace cutaway {

/// Hears of changes until it is gone; then of none that is under way either.
class ListingWatch {
 public:
  explicit ListingWatch(std::function<void()> changed) : changed_(std::move(changed)) {}
  void call() {
    const std::lock_guard lock(mutex_);
    if (changed_) changed_();
  }
  void dismiss() {
    const std::lock_guard lock(mutex_);
    changed_ = nullptr;
  }

 private:
  std::mutex mutex_;
  std::function<void()> changed_;
};

namespace {

class WatchTicket final : public OpenTicket {
 public:
  explicit WatchTicket(std::shared_ptr<ListingWatch> watch) : watch_(std::move(watch)) {}
  ~WatchTicket() override { watch_->dismiss(); }
  WatchTicket(const WatchTicket&) = delete;
  WatchTicket& operator=(const WatchTicket&) = delete;

 private:
  std::shared_ptr<ListingWatch> watch_;
};

// Before the voxels are read: at most as many bytes as floats take.
std::uint64_t expected_bytes(const VolumeGeometry& geometry) {
  const glm::u64vec3 size(geometry.size_voxels);
  return size.x * size.y * size.z * sizeof(float);
}

// A client may ask for what there is not: that is no trouble of the server's. A file that cannot be
// read is.
spdlog::level::level_enum level_of(const Error& error) {
  const ErrorCode code = error.detail().code;
  const bool asked_in_vain = code == ErrorCode::unknown_volume || code == ErrorCode::out_of_range;
  return asked_in_vain ? spdlog::level::debug : spdlog::level::warn;
}

}  // namespace

std::uint64_t memory_limit(const VolumeSettings& settings) {
  return settings.memory_bytes > 0 ? settings.memory_bytes : machine_memory_bytes() / 2;
}

/// Someone who wants to hear that a volume is prepared; once dismissed it hears nothing.
class PreparationWish {
 public:
  explicit PreparationWish(std::function<void()> ready) : ready_(std::move(ready)) {}
  void call() { ready_.call(); }
  void dismiss() {
    stop_.request_stop();
    ready_.dismiss();
  }
  std::stop_token stop() const { return stop_.get_token(); }

 private:
  ListingWatch ready_;
  std::stop_source stop_;
};

class PreparationTicket final : public OpenTicket {
 public:
  explicit PreparationTicket(std::shared_ptr<PreparationWish> wish) : wish_(std::move(wish)) {}
  ~PreparationTicket() override { wish_->dismiss(); }
  PreparationTicket(const PreparationTicket&) = delete;
  PreparationTicket& operator=(const PreparationTicket&) = delete;

 private:
  std::shared_ptr<PreparationWish> wish_;
};

/// Holds the job for as long as someone waits for it.
class LoadTicket final : public OpenTicket {
 public:
  LoadTicket(VolumeService& service, std::shared_ptr<LoadJob> job,
             std::shared_ptr<LoadWaiter> waiter)
      : service_(service), job_(std::move(job)), waiter_(std::move(waiter)) {}
  ~LoadTicket() override { service_.withdraw(job_, waiter_); }
  LoadTicket(const LoadTicket&) = delete;
  LoadTicket& operator=(const LoadTicket&) = delete;

 private:
  VolumeService& service_;
  std::shared_ptr<LoadJob> job_;
  std::shared_ptr<LoadWaiter> waiter_;
};

VolumeService::VolumeService(const VolumeSettings& settings, UploadTarget target)
    : target_(std::move(target)),
      cache_(memory_limit(settings)),
      pool_(settings.load_threads),
      catalogue_(settings, [this] { listing_changed(); }) {}

VolumeService::~VolumeService() {
  pool_.stop();
  preview_pool_.stop();
  preparing_pool_.stop();
}

std::unique_ptr<OpenTicket> VolumeService::watch(std::function<void()> changed) {
  const auto watch = std::make_shared<ListingWatch>(std::move(changed));
  const std::lock_guard lock(mutex_);
  std::erase_if(watches_, [](const auto& each) { return each.expired(); });
  watches_.push_back(watch);
  return std::make_unique<WatchTicket>(watch);
}

void VolumeService::listing_changed() noexcept try {
  std::list<std::weak_ptr<ListingWatch>> watches;
  std::list<std::shared_ptr<LoadJob>> jobs;
  {
    const std::lock_guard lock(mutex_);
    watches = watches_;
    jobs.swap(put_by_);
  }
  for (const auto& job : jobs) {
    job->give_back();
    begin(job, pool_);
  }
  for (const auto& each : watches) {
    if (const auto watch = each.lock()) watch->call();
  }
} catch (const std::exception& failure) {
  log().error("a changed list of volumes was not told: {}", failure.what());
}

std::unique_ptr<OpenTicket> VolumeService::open(const std::string& id, ProgressSink progress,
                                                std::function<void(OpenOutcome)> done) {
  return join(id, std::make_shared<LoadWaiter>(std::move(progress), std::move(done)), pool_);
}

std::unique_ptr<OpenTicket> VolumeService::open_for_preview(const std::string& id,
                                                            std::function<void(OpenOutcome)> done) {
  return join(id, std::make_shared<LoadWaiter>(nullptr, std::move(done)), preview_pool_);
}

// A job that waits behind others for a preview is begun at once when someone wants to see it.
std::unique_ptr<OpenTicket> VolumeService::join(const std::string& id,
                                                std::shared_ptr<LoadWaiter> waiter,
                                                WorkerPool& pool) {
  const std::lock_guard lock(mutex_);
  std::shared_ptr<LoadJob>& job = jobs_[id];
  const bool is_new = job == nullptr;
  if (is_new) job = std::make_shared<LoadJob>(id);
  job->join(waiter);
  if (is_new || &pool == &pool_) begin(job, pool);
  return std::make_unique<LoadTicket>(*this, job, std::move(waiter));
}

void VolumeService::begin(const std::shared_ptr<LoadJob>& job, WorkerPool& pool) {
  pool.post([this, job] {
    if (job->claim()) load(job);
  });
}

std::shared_ptr<const OpenedVolume> VolumeService::find_opened(const std::string& id) {
  const std::lock_guard lock(mutex_);
  return cache_.find(id);
}

std::shared_ptr<const LoadedVolume> VolumeService::loaded(const std::string& id) {
  const auto volume = find_opened(id);
  return volume ? volume->loaded() : nullptr;
}

std::shared_ptr<const LoadedVolume> VolumeService::seen_in(const Scene& scene) {
  const auto volume = find_opened(scene.volume);
  return volume ? volume->seen_in(scene) : nullptr;
}

// Asked for twice it is made once: there is one thread, and the second finds it.
std::unique_ptr<OpenTicket> VolumeService::prepare(const Scene& scene,
                                                   std::function<void()> ready) {
  const auto opened = find_opened(scene.volume);
  if (!opened) return nullptr;
  const VolumePreparation wanted = preparation_of(scene, *opened->loaded());
  if (wanted.is_nothing() || opened->prepared().find(wanted)) return nullptr;
  auto wish = std::make_shared<PreparationWish>(std::move(ready));
  preparing_pool_.post([this, opened, wanted, wish] {
    try {
      if (!opened->prepared().find(wanted)) {
        const auto made = make_prepared(*opened->loaded(), wanted, wish->stop());
        if (!made) return;
        target_.upload(
            made, [](LoadStage, double) {}, wish->stop());
        opened->prepared().put(wanted, made);
      }
      wish->call();
    } catch (const Cancelled&) {
    } catch (const std::exception& failure) {
      log().warn("{} was not prepared: {}", opened->facts().id, failure.what());
    }
  });
  return std::make_unique<PreparationTicket>(std::move(wish));
}

std::shared_ptr<const LoadedVolume> VolumeService::make_prepared(
    const LoadedVolume& measured, const VolumePreparation& preparation,
    const std::stop_token& stop) {
  const std::uint64_t bytes = memory_bytes(measured);
  try {
    const std::lock_guard lock(mutex_);
    cache_.make_room(reserved_bytes_ + bytes);
    reserved_bytes_ += bytes;
  } catch (const Error& error) {
    log().info("{} is shown as it is: {}", measured.volume.description.id, error.what());
    return nullptr;
  }
  const auto give_back = [&] {
    const std::lock_guard lock(mutex_);
    reserved_bytes_ -= bytes;
  };
  try {
    auto made = cutaway::prepare(measured, preparation, stop);
    give_back();
    return made;
  } catch (...) {
    give_back();
    throw;
  }
}

void VolumeService::load(const std::shared_ptr<LoadJob>& job) {
  const std::string& id = job->id();
  try {
    if (const auto entry = find(job)) finish(*job, read(*entry, *job));
  } catch (const Cancelled&) {
    finish(*job, Cancelled());
  } catch (const Error& error) {
    log().log(level_of(error), "{} was not opened: {}", id, error.what());
    finish(*job, error_for_client(error, id));
  } catch (const std::bad_alloc&) {
    finish(*job, Error({.code = ErrorCode::too_large,
                        .message = "there is not enough memory for this volume",
                        .field = "/volume",
                        .received = id}));
  } catch (const std::exception& failure) {
    log().error("{} was not opened: {}", id, failure.what());
    finish(*job, Error({.code = ErrorCode::internal,
                        .message = "the volume could not be read",
                        .field = "/volume",
                        .received = id}));
  }
}

// Looked up and put by in one step: a listing that changes in between would be missed.
std::optional<CatalogueEntry> VolumeService::find(const std::shared_ptr<LoadJob>& job) {
  const std::lock_guard lock(mutex_);
  throw_if_cancelled(job->stop());
  auto entry = catalogue_.find(job->id());
  if (!entry) put_by_.push_back(job);
  return entry;
}

std::shared_ptr<const OpenedVolume> VolumeService::read(const CatalogueEntry& entry, LoadJob& job) {
  check_texture_limit(entry.geometry.size_voxels, target_.largest_edge_voxels);
  const std::uint64_t bytes = expected_bytes(entry.geometry);
  if (auto volume = reserve(job.id(), bytes)) return volume;
  try {
    auto opened = read_reserved(entry, job);
    const std::lock_guard lock(mutex_);
    reserved_bytes_ -= bytes;
    cache_.add(opened);
    return opened;
  } catch (...) {
    const std::lock_guard lock(mutex_);
    reserved_bytes_ -= bytes;
    throw;
  }
}

std::shared_ptr<const OpenedVolume> VolumeService::reserve(const std::string& id,
                                                           std::uint64_t bytes) {
  const std::lock_guard lock(mutex_);
  if (auto volume = cache_.find(id)) return volume;
  cache_.make_room(reserved_bytes_ + bytes);
  reserved_bytes_ += bytes;
  return nullptr;
}

// The volume goes by the name it was asked for: the scene says that name, and the renderer looks
// for it.
std::shared_ptr<const OpenedVolume> VolumeService::read_reserved(const CatalogueEntry& entry,
                                                                 LoadJob& job) {
  const ProgressSink progress = [&job](LoadStage stage, double fraction) {
    job.progress(stage, fraction);
  };
  Volume volume = entry.read(progress, job.stop());
  volume.description.id = job.id();
  const auto measured = derive_loaded_volume(std::move(volume), progress, job.stop());
  const VolumePreparation first = preparation_of_first_look(*measured);
  auto seen = first.is_nothing() ? nullptr : make_prepared(*measured, first, job.stop());
  if (!seen) seen = measured;
  target_.upload(seen, progress, job.stop());
  return std::make_shared<const OpenedVolume>(measured, seen);
}

// Whoever asks from here on finds the volume in the cache, or tries anew.
void VolumeService::finish(LoadJob& job, OpenOutcome outcome) {
  {
    const std::lock_guard lock(mutex_);
    const auto mine = jobs_.find(job.id());
    if (mine != jobs_.end() && mine->second.get() == &job) jobs_.erase(mine);
  }
  job.finish(std::move(outcome));
}

void VolumeService::withdraw(const std::shared_ptr<LoadJob>& job,
                             const std::shared_ptr<LoadWaiter>& waiter) {
  waiter->dismiss();
  const std::lock_guard lock(mutex_);
  if (!job->leave(waiter)) return;
  put_by_.remove(job);
  const auto mine = jobs_.find(job->id());
  if (mine != jobs_.end() && mine->second == job) jobs_.erase(mine);
}

}  // namespace cutaway
