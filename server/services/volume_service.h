// The server's volumes: lists them, loads them, shares and keeps what is loaded.
#pragma once

#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "core/worker_pool.h"
#include "services/settings.h"
#include "services/upload_target.h"
#include "services/volume_cache.h"
#include "services/volume_catalogue.h"
#include "session/volume_library.h"

namespace cutaway {

class LoadJob;
class LoadWaiter;
class ListingWatch;

/// Bytes that all loaded volumes together may take.
std::uint64_t memory_limit(const VolumeSettings& settings);

/// Thread-safe. One load serves all who wait for the same volume; it is cancelled when the last of
/// them goes.
class VolumeService final : public VolumeLibrary {
 public:
  VolumeService(const VolumeSettings& settings, UploadTarget target);
  /// After every ticket is gone. Waits for loads to stop.
  ~VolumeService() override;
  VolumeService(const VolumeService&) = delete;
  VolumeService& operator=(const VolumeService&) = delete;

  Json listing() const override { return catalogue_.listing(); }
  std::unique_ptr<OpenTicket> watch(std::function<void()> changed) override;
  std::unique_ptr<OpenTicket> open(const std::string& id, ProgressSink progress,
                                   std::function<void(OpenOutcome)> done) override;
  std::unique_ptr<OpenTicket> open_for_preview(const std::string& id,
                                               std::function<void(OpenOutcome)> done) override;

  std::unique_ptr<OpenTicket> prepare(const Scene& scene, std::function<void()> ready) override;

  /// As it was measured; null where it is not loaded.
  std::shared_ptr<const LoadedVolume> loaded(const std::string& id);
  /// The scene's volume for the renderer, as OpenedVolume has it; null where it is not loaded.
  std::shared_ptr<const LoadedVolume> seen_in(const Scene& scene);

 private:
  friend class LoadTicket;

  void listing_changed() noexcept;
  std::unique_ptr<OpenTicket> join(const std::string& id, std::shared_ptr<LoadWaiter> waiter,
                                   WorkerPool& pool);
  void begin(const std::shared_ptr<LoadJob>& job, WorkerPool& pool);
  void load(const std::shared_ptr<LoadJob>& job);
  /// Where the volume lies; nothing where the job is put by until the listing has changed.
  std::optional<CatalogueEntry> find(const std::shared_ptr<LoadJob>& job);
  std::shared_ptr<const OpenedVolume> read(const CatalogueEntry& entry, LoadJob& job);
  /// The volume where it is loaded already; else room for it is set aside.
  std::shared_ptr<const OpenedVolume> reserve(const std::string& id, std::uint64_t bytes);
  std::shared_ptr<const OpenedVolume> find_opened(const std::string& id);
  /// The volume, prepared; null where memory has no room for it.
  std::shared_ptr<const LoadedVolume> make_prepared(const LoadedVolume& measured,
                                                    const VolumePreparation& preparation,
                                                    const std::stop_token& stop);
  std::shared_ptr<const OpenedVolume> read_reserved(const CatalogueEntry& entry, LoadJob& job);
  void finish(LoadJob& job, OpenOutcome outcome);
  void withdraw(const std::shared_ptr<LoadJob>& job, const std::shared_ptr<LoadWaiter>& waiter);

  UploadTarget target_;
  std::mutex mutex_;  ///< of the cache, the reservation, the jobs and the watches
  VolumeCache cache_;
  std::uint64_t reserved_bytes_ = 0;  ///< for loads under way
  std::map<std::string, std::shared_ptr<LoadJob>> jobs_;
  std::list<std::shared_ptr<LoadJob>> put_by_;  ///< of volumes that the scan has not found yet
  std::list<std::weak_ptr<ListingWatch>> watches_;
  WorkerPool pool_;
  WorkerPool preview_pool_{1};  ///< one at a time, whoever wants them
  WorkerPool preparing_pool_{1};
  VolumeCatalogue catalogue_;  ///< last: its thread calls listing_changed
};

}  // namespace cutaway
