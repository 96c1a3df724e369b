// SPDX-License-Identifier: MIT
#include "plan/omission.h"

#include <algorithm>

#include "base/lists.h"
#include "plan/facts.h"
#include "plan/named.h"
#include "plan/sizes.h"

namespace strobe::plan {
namespace {

// The reason that a node does not run, and its stand-ins: "nothing moves in this frame: blurred = color".
std::string reasonOf(const WithoutDesc& without) {
  const Fact* fact = findFact(without.name);
  std::vector<std::string> ports;
  for (const auto& [write, read] : without.writes)
    ports.push_back(fmt::format("{} = {}", write, read.empty() ? "0" : read));
  std::string why = fact ? fact->absent : fmt::format("'{}' is 0 everywhere", without.name);
  return fmt::format("{}: {}", why, fmt::join(ports, ", "));
}

class Omitter {
 public:
  Omitter(const PipelineDesc& pipeline, const std::vector<std::string>& absent, Wiring& wiring)
      : pipeline_(pipeline), absent_(absent), wiring_(wiring), chosen_(wiring.nodes.size()) {}

  std::vector<std::string> run() {
    seen_.assign(wiring_.nodes.size(), false);
    for (const WiredLoop& loop : wiring_.loops)
      if (loop.until.node >= 0) stops_.push_back(loop.until.node);
    for (size_t i = 0; i < wiring_.nodes.size(); ++i) visit(int(i));
    for (auto* kept : {&wiring_.outputs, &wiring_.taps})
      for (PortSource& source : *kept) source = standIn(source);
    std::vector<std::string> reasons;
    for (const WithoutDesc* without : chosen_) reasons.push_back(without ? reasonOf(*without) : "");
    return reasons;
  }

 private:
  // Visits the nodes that are read first.
  void visit(int index) {
    if (seen_[size_t(index)]) return;
    seen_[size_t(index)] = true;
    WiredNode& node = wiring_.nodes[size_t(index)];
    for (PortSource& source : node.reads) {
      if (source.node < 0) continue;
      visit(source.node);
      source = standIn(source);
    }
    unwireUseless(node);
    for (const WithoutDesc& without : passOf(index).without) {
      if (!lacks(index, without.name) || !readsBackAlike(index, without)) continue;
      chosen_[size_t(index)] = &without;
      node.blank = true;
      return;
    }
  }

  // Unwires optional reads if all their `needs` are unwired or zero.
  void unwireUseless(WiredNode& node) {
    const std::vector<PortDesc>& reads = pipeline_.passes[size_t(node.pass)].reads;
    const std::vector<PortSource> sources = node.reads;
    auto isWithout = [&](const std::string& needed) {
      const PortSource& source = sources[size_t(indexOf(reads, needed))];
      return source.node < 0 || isZero(source);
    };
    for (size_t r = 0; r < reads.size(); ++r) {
      const std::vector<std::string>& needs = reads[r].needs;
      if (!needs.empty() && std::all_of(needs.begin(), needs.end(), isWithout)) node.reads[r] = PortSource();
    }
  }

  bool lacks(int index, const std::string& name) const {
    if (contains(absent_, name)) return true;
    int read = indexOf(passOf(index).reads, name);
    return read >= 0 && isZero(readOf(index, read));
  }

  // True if the source is a node that is left out. Stand-ins are wired before, so the remaining source is zeros.
  bool isZero(const PortSource& source) const { return source.node >= 0 && chosen_[size_t(source.node)]; }

  bool readsBackAlike(int index, const WithoutDesc& without) {
    if (contains(stops_, index)) return false;
    return std::all_of(without.writes.begin(), without.writes.end(), [&](const auto& port) {
      if (port.second.empty()) return true;
      PortSource write = {index, indexOf(passOf(index).writes, port.first)};
      return isAlike(write, readOf(index, indexOf(passOf(index).reads, port.second)));
    });
  }

  bool isAlike(const PortSource& a, const PortSource& b) {
    const NodeSize of_a = sizeOf(pipeline_, wiring_, a.node), of_b = sizeOf(pipeline_, wiring_, b.node);
    return of_a.width == of_b.width && of_a.height == of_b.height && formatOf(a) == formatOf(b);
  }

  PortSource standIn(const PortSource& source) const {
    const WithoutDesc* without = source.node < 0 ? nullptr : chosen_[size_t(source.node)];
    if (!without) return source;
    const std::string& read = without->writes[size_t(source.port)].second;
    return read.empty() ? source : readOf(source.node, indexOf(passOf(source.node).reads, read));
  }

  const std::string& formatOf(const PortSource& source) const {
    return plan::formatOf(portOf(pipeline_, wiring_, source), wiring_.nodes[size_t(source.node)].params);
  }

  const PortSource& readOf(int index, int read) const { return wiring_.nodes[size_t(index)].reads[size_t(read)]; }
  const PassDesc& passOf(int index) const { return pipeline_.passes[size_t(wiring_.nodes[size_t(index)].pass)]; }

  const PipelineDesc& pipeline_;
  const std::vector<std::string>& absent_;
  Wiring& wiring_;
  std::vector<const WithoutDesc*> chosen_;  // per node; null if the node runs
  std::vector<bool> seen_;
  std::vector<int> stops_;  // nodes with the stop condition of a loop
};

}  // namespace

std::vector<std::string> leaveOut(const PipelineDesc& pipeline, const std::vector<std::string>& absent,
                                  Wiring& wiring) {
  return Omitter(pipeline, absent, wiring).run();
}

}  // namespace strobe::plan
