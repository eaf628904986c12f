#include "cocone/max_flow.h"

#include <algorithm>

namespace cocoon {
namespace {

constexpr std::uint32_t no_level = 0xFFFFFFFFU;

}  // namespace

MaxFlow::MaxFlow(std::size_t count) : nodes_(count + 2), excess_(count, 0) {}

void MaxFlow::add_edge(std::uint32_t a, std::uint32_t b, std::int64_t cost) {
  edges_.push_back({a, b, cost, cost});
}

void MaxFlow::build_arcs() {
  const auto source = static_cast<std::uint32_t>(nodes_ - 2);
  const auto sink = static_cast<std::uint32_t>(nodes_ - 1);
  for (std::uint32_t v = 0; v < source; ++v) {
    if (excess_[v] > 0) edges_.push_back({source, v, excess_[v], 0});
    if (excess_[v] < 0) edges_.push_back({v, sink, -excess_[v], 0});
  }
  first_.assign(nodes_ + 1, 0);
  for (const Edge& e : edges_) {
    ++first_[e.a + 1];
    ++first_[e.b + 1];
  }
  for (std::size_t v = 0; v < nodes_; ++v) first_[v + 1] += first_[v];
  order_.resize(2 * edges_.size());
  std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
  for (const Edge& e : edges_) {
    order_[fill[e.a]++] = static_cast<std::uint32_t>(arcs_.size());
    arcs_.push_back({e.b, e.forth});
    order_[fill[e.b]++] = static_cast<std::uint32_t>(arcs_.size());
    arcs_.push_back({e.a, e.back});
  }
  edges_.clear();
}

// Breadth first from the source over what is not saturated; true if the sink is reached.
bool MaxFlow::find_levels() {
  const auto source = static_cast<std::uint32_t>(nodes_ - 2);
  level_.assign(nodes_, no_level);
  level_[source] = 0;
  std::vector<std::uint32_t> queue{source};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const std::uint32_t v = queue[i];
    for (std::uint32_t k = first_[v]; k < first_[v + 1]; ++k) {
      const Arc& arc = arcs_[order_[k]];
      if (arc.capacity <= 0 || level_[arc.to] != no_level) continue;
      level_[arc.to] = level_[v] + 1;
      queue.push_back(arc.to);
    }
  }
  return level_[nodes_ - 1] != no_level;
}

// Saturates the path and cuts it back to before its first saturated arc.
void MaxFlow::augment(std::vector<Step>& path) {
  std::int64_t amount = arcs_[path.front().arc].capacity;
  for (const Step& s : path) amount = std::min(amount, arcs_[s.arc].capacity);
  std::size_t keep = path.size();
  for (std::size_t i = path.size(); i-- > 0;) {
    arcs_[path[i].arc].capacity -= amount;
    arcs_[path[i].arc ^ 1U].capacity += amount;
    if (arcs_[path[i].arc].capacity == 0) keep = i;
  }
  path.resize(keep);
}

// Depth first along rising levels, without recursion.
void MaxFlow::push_blocking_flow() {
  const auto source = static_cast<std::uint32_t>(nodes_ - 2);
  const auto sink = static_cast<std::uint32_t>(nodes_ - 1);
  next_.assign(first_.begin(), first_.end() - 1);
  std::vector<Step> path;
  for (;;) {
    const std::uint32_t v = path.empty() ? source : arcs_[path.back().arc].to;
    if (v == sink) {
      augment(path);
      continue;
    }
    for (; next_[v] < first_[v + 1]; ++next_[v]) {
      const Arc& arc = arcs_[order_[next_[v]]];
      if (arc.capacity > 0 && level_[arc.to] == level_[v] + 1) break;
    }
    if (next_[v] < first_[v + 1]) {
      path.push_back({order_[next_[v]], v});
    } else if (path.empty()) {
      return;
    } else {
      ++next_[path.back().from];  // a dead end
      path.pop_back();
    }
  }
}

std::vector<std::uint8_t> MaxFlow::source_side() {
  build_arcs();
  while (find_levels()) push_blocking_flow();
  std::vector<std::uint8_t> side(nodes_ - 2, 0);
  for (std::size_t v = 0; v < side.size(); ++v) side[v] = level_[v] != no_level ? 1 : 0;
  return side;
}

}  // namespace cocoon
