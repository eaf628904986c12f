#include "delaunay/kernel/parallel_insertion.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <memory>
#include <thread>
#include <vector>

#include "delaunay/kernel/vertex_claims.h"

namespace cocoon {
namespace {

// The next point of a run is near the last: a thread keeps its claims until it meets another thread
// or ends the run. When they are more than these it gives back all but those of its last new cell.
constexpr std::size_t claims_kept = 64;
constexpr std::size_t runs_between_reports = 32;
constexpr std::size_t run_length = 512;  // points; long against the walk to its first one

// Fresh cells that a thread takes from the pool for itself: of large triangulations so many that
// two threads rarely come to a new page of memory at once, of small ones so few that hardly any
// are left over. It brings so many at a time into use.
constexpr std::size_t most_slots_taken = std::size_t{1} << 13;
constexpr std::size_t slots_at_a_time = 512;

// --- Who does what ---------------------------------------------------------------------------

// The runs of one thread that nobody has begun: [front, back), in one word that all may change.
class RunQueue {
 public:
  void assign(std::size_t front, std::size_t back) { ends_.store(pack(front, back)); }
  std::size_t size() const {
    const std::uint64_t ends = ends_.load(std::memory_order_relaxed);
    return back_of(ends) - front_of(ends);
  }
  bool take_front(std::size_t& run) {
    std::uint64_t ends = ends_.load(std::memory_order_relaxed);
    do {
      if (front_of(ends) == back_of(ends)) return false;
      run = front_of(ends);
    } while (!ends_.compare_exchange_weak(ends, pack(run + 1, back_of(ends))));
    return true;
  }
  bool take_back(std::size_t& run) {
    std::uint64_t ends = ends_.load(std::memory_order_relaxed);
    do {
      if (front_of(ends) == back_of(ends)) return false;
      run = back_of(ends) - 1;
    } while (!ends_.compare_exchange_weak(ends, pack(front_of(ends), run)));
    return true;
  }

 private:
  static std::uint64_t pack(std::size_t front, std::size_t back) {
    return std::uint64_t{front} << 32 | back;
  }
  static std::size_t front_of(std::uint64_t ends) { return ends >> 32; }
  static std::size_t back_of(std::uint64_t ends) { return ends & 0xFFFFFFFFU; }

  std::atomic<std::uint64_t> ends_{0};
};

// Large blocks of vertices to a claim make claims cheap; many blocks for each thread, conflicts
// rare.
unsigned block_bits(std::size_t count, std::size_t threads) {
  constexpr std::size_t blocks_per_thread = 4096;
  constexpr unsigned most_bits = 6;
  const std::size_t share = count / (blocks_per_thread * threads);
  return std::min(most_bits, static_cast<unsigned>(std::bit_width(share | 1U)) - 1);
}

// --- What the threads share ------------------------------------------------------------------

enum class Stop : int { no = 0, out_of_cells = 1, failed = 2 };

struct Shared {
  CellPool& pool;
  const IdVector<VertexId, Point>& points;
  std::span<const std::uint32_t> order;
  VertexClaims claims;
  std::vector<std::atomic<bool>> is_inserted;  // by vertex
  IdVector<VertexId, CellId> cell_at;          // a cell at each vertex that is inserted
  std::atomic<std::size_t> num_cells;          // slots in use or taken by a thread
  std::atomic<std::size_t> num_inserted;
  std::size_t slots_taken;  // by a thread that needs some
  std::atomic<Stop> stop{Stop::no};

  Shared(CellPool& cells, const IdVector<VertexId, Point>& all_points,
         std::span<const std::uint32_t> all, std::size_t inserted, std::size_t threads)
      : pool(cells),
        points(all_points),
        order(all),
        claims(all_points.size(), block_bits(all_points.size(), threads)),
        is_inserted(all_points.size()),
        cell_at(all_points.size()),
        num_cells(cells.cells.size()),
        num_inserted(inserted),
        slots_taken(std::clamp(all.size() / (64 * threads), slots_at_a_time, most_slots_taken)) {
    for (std::size_t i = 0; i < inserted; ++i) is_inserted[order[i]].store(true);
    for (const CellId c : pool.cells.ids()) {
      if (pool.is_free(c)) continue;
      for (const VertexId v : pool.cells[c].vertices) {
        if (v != infinite_vertex) cell_at[v] = c;
      }
    }
  }

  // The inserted vertex next to v in number, which is next to it on the curve.
  VertexId inserted_neighbor(VertexId v) const {
    const std::size_t count = points.size() - 1;
    // What its inserter wrote is seen.
    const auto has = [&](std::size_t w) { return is_inserted[w].load(std::memory_order_acquire); };
    for (std::size_t away = 1;; ++away) {
      if (v.index() >= away && has(v.index() - away)) return VertexId(v.index() - away);
      if (v.index() + away < count && has(v.index() + away)) return VertexId(v.index() + away);
    }
  }
};

// --- One thread ------------------------------------------------------------------------------

// Padded, so that threads do not write to the same cache line.
class alignas(128) Worker {
 public:
  Worker(Shared& shared, const CavityInserter& model, std::size_t number)
      : shared_(shared),
        holder_(shared.claims, number),
        inserter_(model, {&holder_, &free_, shared.cell_at.raw().data()}) {}

  RunQueue runs;
  DelaunayCounters counters;

  // Inserts the vertices of own runs, then of those left to others, until none are left or all are
  // told to stop.
  void work(std::vector<std::unique_ptr<Worker>>& workers, std::size_t begin, std::size_t end,
            const Execution* execution);
  // All slots that it has taken and does not use; to be called when it has done its work.
  const std::vector<CellId>& free_slots() {
    while (fresh_ != fresh_end_) free_fresh_slots();
    for (const CellId c : free_) shared_.pool.cells[c].vertices[0] = VertexId();
    return free_;
  }

 private:
  bool next_run(std::vector<std::unique_ptr<Worker>>& workers, std::size_t& run);
  void insert_all(std::span<const std::uint32_t> vertices);
  void retry();
  bool try_insert(VertexId v);
  CellId cell_near(VertexId v);
  CellId locate_holding(VertexId v);
  void let_go();
  bool take_room();
  void free_fresh_slots();

  Shared& shared_;
  ClaimHolder holder_;
  std::vector<CellId> free_;
  std::size_t fresh_ = 0, fresh_end_ = 0;  // slots of its own that were never used
  CavityInserter inserter_;
  CellId last_created_;  // held; none if nothing was created since the claims were given back
  std::vector<std::uint32_t> left_;  // vertices given up for now
  std::size_t inserted_ = 0;         // since last added to the shared count
};

bool Worker::next_run(std::vector<std::unique_ptr<Worker>>& workers, std::size_t& run) {
  if (runs.take_front(run)) return true;
  for (;;) {
    Worker* richest = nullptr;
    std::size_t most = 0;
    for (const std::unique_ptr<Worker>& other : workers) {
      const std::size_t size = other->runs.size();
      if (size <= most) continue;
      most = size;
      richest = other.get();
    }
    if (richest == nullptr) return false;
    if (richest->runs.take_back(run)) {
      ++counters.stolen_runs;
      return true;
    }
  }
}

// As many free slots as the zone found wants.
bool Worker::take_room() {
  while (free_.size() < inserter_.num_slots_wanted()) {
    if (fresh_ == fresh_end_) {
      const std::size_t begin = shared_.num_cells.fetch_add(shared_.slots_taken);
      if (begin + shared_.slots_taken > shared_.pool.cells.size()) {
        shared_.num_cells.fetch_sub(shared_.slots_taken);
        shared_.stop.store(Stop::out_of_cells);
        return false;
      }
      fresh_ = begin;
      fresh_end_ = begin + shared_.slots_taken;
    }
    free_fresh_slots();
  }
  return true;
}

void Worker::free_fresh_slots() {
  const std::size_t end = std::min(fresh_end_, fresh_ + slots_at_a_time);
  const auto marks = shared_.pool.marks.begin();
  std::fill(marks + static_cast<std::ptrdiff_t>(fresh_), marks + static_cast<std::ptrdiff_t>(end),
            CellMark::untested);
  std::size_t next = end;  // the first is used first
  const auto count = static_cast<std::ptrdiff_t>(end - fresh_);
  free_.resize(free_.size() + end - fresh_);
  std::generate(free_.end() - count, free_.end(), [&] { return CellId(--next); });
  fresh_ = end;
}

// A cell at the inserted vertex next to v. None if another thread holds that vertex.
CellId Worker::cell_near(VertexId v) {
  const VertexId near = shared_.inserted_neighbor(v);
  return holder_.take(near) ? shared_.cell_at[near] : CellId();
}

// Walks from a cell near v to one in conflict with it, whose vertices are then held. None if
// another thread is in the way.
CellId Worker::locate_holding(VertexId v) {
  const IdVector<CellId, Cell>& cells = shared_.pool.cells;
  CellId current = last_created_.is_none() ? cell_near(v) : last_created_;
  if (current.is_none() || !holder_.take_corners(cells[current])) return {};
  if (is_infinite(cells[current])) {
    current = cell_of(cells[current].neighbors[3]);
    if (!holder_.take_corners(cells[current])) return {};
  }
  return inserter_.find_start(shared_.points[v], current, counters);
}

void Worker::let_go() {
  holder_.release();
  last_created_ = {};
}

// Returns whether v was inserted. If not, nothing was changed.
bool Worker::try_insert(VertexId v) {
  const CellId start = locate_holding(v);
  if (start.is_none() || !inserter_.find_zone(v, start, counters)) {
    let_go();
    return false;
  }
  if (!take_room()) {
    inserter_.abandon_zone();
    let_go();
    return false;
  }
  last_created_ = inserter_.fill_zone(v, counters);
  shared_.is_inserted[v.index()].store(true, std::memory_order_release);
  if (holder_.num_held() > claims_kept) holder_.release_but(shared_.pool.cells[last_created_]);
  ++inserted_;
  return true;
}

void Worker::insert_all(std::span<const std::uint32_t> vertices) {
  for (const std::uint32_t v : vertices) {
    if (shared_.stop.load(std::memory_order_relaxed) != Stop::no || !try_insert(VertexId(v))) {
      left_.push_back(v);
    }
  }
}

// One more attempt for each vertex that was given up. They may be far apart.
void Worker::retry() {
  std::vector<std::uint32_t> again;
  again.swap(left_);
  for (const std::uint32_t& v : again) {
    let_go();
    insert_all({&v, 1});
  }
  let_go();
}

void Worker::work(std::vector<std::unique_ptr<Worker>>& workers, std::size_t begin, std::size_t end,
                  const Execution* execution) {
  const auto stopped = [&] { return shared_.stop.load(std::memory_order_relaxed) != Stop::no; };
  std::size_t run = 0;
  std::size_t runs_done = 0;
  while (!stopped() && next_run(workers, run)) {
    const std::size_t run_begin = begin + run * run_length;
    const std::size_t count = std::min(run_length, end - run_begin);
    const std::size_t known = left_.size();
    insert_all(shared_.order.subspan(run_begin, count));
    if (!stopped()) counters.retries += left_.size() - known;
    retry();
    const std::size_t inserted = shared_.num_inserted.fetch_add(inserted_) + inserted_;
    inserted_ = 0;
    if (execution != nullptr && ++runs_done % runs_between_reports == 0) {
      report_progress(*execution, "delaunay",
                      static_cast<double>(inserted) / static_cast<double>(shared_.order.size()));
    }
  }
  while (!stopped() && !left_.empty()) {
    retry();
    if (!left_.empty()) std::this_thread::yield();
  }
  shared_.num_inserted.fetch_add(inserted_);
  inserted_ = 0;
}

// --- All -------------------------------------------------------------------------------------

class Team {
 public:
  Team(Shared& shared, const CavityInserter& model, std::size_t threads, const Execution& execution)
      : shared_(shared), execution_(execution), caller_(std::this_thread::get_id()) {
    for (std::size_t i = 0; i < threads; ++i) {
      workers_.push_back(std::make_unique<Worker>(shared, model, i));
    }
  }

  void insert_round(std::size_t begin, std::size_t end) {
    const std::size_t runs = (end - begin + run_length - 1) / run_length;
    for (std::size_t i = 0; i < workers_.size(); ++i) {
      workers_[i]->runs.assign(runs * i / workers_.size(), runs * (i + 1) / workers_.size());
    }
    std::size_t room = shared_.pool.cells.raw().capacity();
    for (;;) {
      make_room(room);
      shared_.stop.store(Stop::no);
      parallel_chunks(execution_, workers_.size(), 1,
                      [&](std::size_t i, std::size_t) { run_worker(*workers_[i], begin, end); });
      if (shared_.stop.load() == Stop::no) return;
      room = shared_.pool.cells.size() + shared_.pool.cells.size() / 2;
    }
  }

  // Makes the pool one thread's again.
  void finish(DelaunayCounters& counters) {
    CellPool& pool = shared_.pool;
    const std::size_t used = shared_.num_cells.load();
    for (const std::unique_ptr<Worker>& worker : workers_) {
      const std::vector<CellId>& slots = worker->free_slots();
      pool.free.insert(pool.free.end(), slots.begin(), slots.end());
      counters += worker->counters;
    }
    pool.cells.resize(used);
    pool.marks.resize(used);
  }

 private:
  // For `expected` cells, as far as they can be numbered, and at least one block for each thread.
  void make_room(std::size_t expected) {
    CellPool& pool = shared_.pool;
    const std::size_t used = shared_.num_cells.load();
    const std::size_t least = used + workers_.size() * shared_.slots_taken;
    const std::size_t count = std::min(std::max(expected, least), max_cells);
    require_cell_numbers(least);
    if (count <= pool.cells.size()) return;
    pool.cells.resize_for_overwrite(count);
    pool.marks.resize_for_overwrite(count);
  }

  void run_worker(Worker& worker, std::size_t begin, std::size_t end) {
    const bool on_calling_thread = std::this_thread::get_id() == caller_;
    try {
      worker.work(workers_, begin, end, on_calling_thread ? &execution_ : nullptr);
    } catch (...) {
      shared_.stop.store(Stop::failed);
      throw;
    }
  }

  Shared& shared_;
  Execution execution_;
  std::thread::id caller_;
  std::vector<std::unique_ptr<Worker>> workers_;
};

}  // namespace

void insert_in_parallel(CellPool& pool, const IdVector<VertexId, Point>& points,
                        const CavityInserter& first_inserter, std::span<const std::uint32_t> order,
                        std::span<const std::size_t> round_ends, std::size_t first,
                        DelaunayCounters& counters, const Execution& execution) {
  const std::size_t threads =
      std::min(static_cast<std::size_t>(thread_count(execution)), VertexClaims::max_holders);
  Shared shared(pool, points, order, first, threads);
  Team team(shared, first_inserter, threads, execution);
  for (const std::size_t end : round_ends) {
    if (end > first) team.insert_round(first, end);
    first = std::max(first, end);
  }
  team.finish(counters);
}

}  // namespace cocoon
