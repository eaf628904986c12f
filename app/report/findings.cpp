#include "app/report/findings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>

#include "geom/messages/counted.h"
#include "geom/messages/place_name.h"

namespace cocoon::app {

namespace {

// A deviation of normal noise from the median roughness it causes (surface_doubts.h).
double noise_of(double roughness) { return roughness / 0.7; }

// "12 samples (1 more is beside a gap)"
std::string sparse_samples(const SurfaceDoubts& d) {
  if (d.boundary_samples == 0) return counted(d.gap_samples, "sample") + " beside gaps";
  std::string samples = counted(d.boundary_samples, "sample");
  if (d.gap_samples == 0) return samples;
  return fmt::format("{} ({} beside gaps)", samples, counted(d.gap_samples, "more is", "more are"));
}

// How many times something is longer: one may be astronomically far away.
std::string ratio(double times) {
  return times < 1e6 ? fmt::format("{:.1f}", times) : fmt::format("{:.3g}", times);
}

// Of doubles some are so far apart that their distance is none.
std::string longest_edge(const DoubtfulSpot& spot, double spacing) {
  if (!std::isfinite(spot.size)) {
    return "too long to be measured, since a point lies too far from the others (leave it out)";
  }
  return fmt::format("{:.3g} ({} times the median)", spot.size, ratio(spot.size / spacing));
}

double share(std::size_t count, std::size_t of) {
  return of == 0 ? 0 : static_cast<double>(count) / static_cast<double>(of);
}

std::string percent(double share) {
  return fmt::format("{:.{}f} %", 100 * share, share < 0.1 ? 1 : 0);
}

// `may_overlap`: the surface is doubtful, and neither noise nor lack of samples is why: then scans
// may overlap there without agreeing.
std::string remedy_of_sparse(bool may_overlap, NoiseFilter filter) {
  if (filter == NoiseFilter::no_noise) return "a smaller SPACING of --densify may help";
  if (filter == NoiseFilter::not_used_on_mesh) {
    return std::string("scan such places more densely, ") + remedy_of_mesh;
  }
  return may_overlap && filter == NoiseFilter::not_used
             ? "scan such places more densely, or try --noise robust if scans overlap there"
             : "scan such places more densely";
}

// The triangles that close it may be left out.
constexpr const char* remedy_of_unscanned = ", or leave open what was not scanned (--trim 8)";

// `guess`: the share of the samples where the surface is one; 0: few.
Finding sparse_finding(const SurfaceDoubts& d, double guess, NoiseFilter filter,
                       const std::string& remedy_of_gap) {
  return {"sparse",
          fmt::format(
              "samples are too sparse, or edges too sharp, at {}; the longest triangle edge "
              "there is {}, near {}; {}{}{}",
              sparse_samples(d), longest_edge(d.sparse[0], d.spacing), place_name(d.sparse[0].at),
              guess > 0 ? "the surface is a guess at " + percent(guess) + " of them all; "
                        : std::string(),
              remedy_of_sparse(false, filter), remedy_of_gap),
          d.boundary_samples + d.gap_samples, d.sparse, guess > 0};
}

// "; the narrowest is 12.3 (4.1 times the spacing) around, near (1, 2, 3)", if it is known
std::string narrowest_handle(const SurfaceDoubts& d) {
  if (d.handles.empty()) return "";
  const DoubtfulSpot& spot = d.handles[0];
  return fmt::format("; {} is {:.3g} ({} times the spacing) around, near {}",
                     d.certificate.genus == 1 ? "it" : "the narrowest", spot.size,
                     ratio(spot.size / d.spacing), place_name(spot.at));
}

// `guess`: the share of the samples where the surface is one; `remedy`: of a false one.
Finding handles_finding(const SurfaceDoubts& d, double guess, bool warns,
                        const std::string& remedy) {
  const std::size_t handles = d.certificate.genus.value_or(0);
  const std::string known = "the surface has " + counted(handles, "handle");
  const std::string where = narrowest_handle(d);
  if (!warns) {
    return {"handles", fmt::format("{}{}; see if the object has as many", known, where), handles,
            d.handles, false};
  }
  return {"handles",
          fmt::format("{} and is a guess at {} of the samples{}; if the object does not have as "
                      "many, {}",
                      known, percent(guess), where, remedy),
          handles, d.handles};
}

Finding conflicts_finding(const SurfaceDoubts& d, const std::string& remedy) {
  const std::string where =
      d.contradicted.empty() ? "" : ", most near " + place_name(d.contradicted[0].at);
  return {"conflicts",
          fmt::format("samples contradict each other {} about what is inside{}; walls may be "
                      "joined or missing; look at the result; {}",
                      counted(d.conflicts, "time"), where, remedy),
          d.conflicts, d.contradicted};
}

// Samples as far apart as advised have noise of this share of their spacing, which hardly harms.
constexpr double harmless_noise = 0.15;

std::string remedy_of_noise(double noise, NoiseFilter filter) {
  if (filter == NoiseFilter::no_noise) return "smooth the mesh first";
  return fmt::format(
      "{} --thin {:.2g}, which leaves out points that lie closer",
      is_filter_left(filter) ? "try --noise robust, or" : "smooth the points, or try",
      noise / harmless_noise);
}

Finding noise_finding(const SurfaceDoubts& d, bool warns, NoiseFilter filter) {
  const double noise = noise_of(d.roughness);
  return {"noise",
          fmt::format("noise is about {:.0f} % of the spacing {:.3g}; {}", 100 * noise, d.spacing,
                      remedy_of_noise(noise * d.spacing, filter)),
          0,
          {},
          warns};
}

Finding fragments_finding(const SurfaceDoubts& d, NoiseFilter filter) {
  const bool leaves_out_strays =
      filter == NoiseFilter::of_strays || filter == NoiseFilter::not_used;
  return {
      "fragments",
      fmt::format("{} beside the main surface; {} has {} and is {:.3g} across, near {}; add "
                  "samples there or remove stray ones{}",
                  counted(d.fragments, "small part"), d.fragments == 1 ? "it" : "the largest",
                  counted(d.dust[0].count, "triangle"), d.dust[0].size, place_name(d.dust[0].at),
                  leaves_out_strays ? " (as --noise robust does)" : ""),
      d.fragments, d.dust};
}

// `trimmed`: of the `unused` points those that --trim left out.
std::string reason_of_unused(std::size_t unused, std::size_t trimmed, NoiseFilter filter,
                             bool cavities) {
  if (trimmed >= unused) return "they went with the long triangles that --trim leaves out";
  if (trimmed > 0) {
    return std::to_string(trimmed) + " of them went with the long triangles that --trim leaves " +
           "out, else " + reason_of_unused(unused, 0, filter, cavities);
  }
  if (filter == NoiseFilter::used) return "such count as noise or outliers";
  const bool is_option_of_command =
      filter != NoiseFilter::of_strays && filter != NoiseFilter::no_option;
  std::string reason;
  if (filter != NoiseFilter::no_noise) {
    reason = filter == NoiseFilter::no_option ? "outliers, "
                                              : "outliers (--noise robust finds more of them), ";
  }
  reason += "inner surfaces";
  if (cavities && is_option_of_command) reason += " (--cavities keeps them)";
  return reason + ", or samples too sparse there";
}

Finding unused_finding(const SurfaceDoubts& d, std::size_t points, bool warns, NoiseFilter filter,
                       const OptionsLeft& left) {
  return {
      "unused",
      fmt::format("{} of {} points {} not on the surface; {} is {:.3g} ({} times the "
                  "spacing) off, at {}; {}",
                  d.unused_points, points, d.unused_points == 1 ? "is" : "are",
                  d.unused_points == 1 ? "it" : "the farthest", d.unused[0].size,
                  ratio(d.unused[0].size / d.spacing), place_name(d.unused[0].at),
                  reason_of_unused(d.unused_points, left.trimmed_points, filter, left.cavities)),
      d.unused_points, d.unused, warns};
}

// "3 edges and 1 vertex"; only what there is
std::string contacts_of(const SurfaceDoubts& d) {
  std::string edges = counted(d.bad_edges, "edge");
  std::string vertices = counted(d.pinched_vertices, "vertex", "vertices");
  if (d.pinched_vertices == 0) return edges;
  return d.bad_edges == 0 ? vertices : edges + " and " + vertices;
}

Finding contacts_finding(const SurfaceDoubts& d, bool manifold) {
  return {
      "contacts",
      fmt::format("the surface touches itself at {}, as near {}{}", contacts_of(d),
                  place_name(d.contacts[0].at), manifold ? "; --manifold parts the sheets" : ""),
      d.bad_edges + d.pinched_vertices, d.contacts};
}

}  // namespace

bool is_filter_left(NoiseFilter filter) {
  return filter == NoiseFilter::not_used || filter == NoiseFilter::not_used_on_mesh;
}

std::vector<Finding> findings_of(const SurfaceDoubts& d, std::size_t points, NoiseFilter filter,
                                 const FindingLimits& limits, const OptionsLeft& left) {
  std::vector<Finding> findings;
  if (d.spacing == 0) return findings;
  const double guess = share(d.unsurrounded_samples, d.samples);
  const bool many = share(d.boundary_samples, points) > limits.sparse_share;
  const bool is_guess = guess > limits.guess_share;
  if (!d.sparse.empty() && (many || d.gap_samples > 0 || is_guess)) {
    const double longest = d.sparse[0].size;
    const bool has_gap = longest > limits.gap_edge * d.spacing && std::isfinite(longest);
    findings.push_back(sparse_finding(d, is_guess ? guess : 0, filter,
                                      has_gap && left.trim ? remedy_of_unscanned : ""));
  }
  const bool noisy = noise_of(d.roughness) > limits.noise;
  const auto place_of_noise = static_cast<std::ptrdiff_t>(findings.size());
  if (d.fragments > 0) findings.push_back(fragments_finding(d, filter));
  const std::string remedy = remedy_of_sparse(!noisy && !is_guess, filter);
  if (d.certificate.genus.value_or(0) > 0 && guess > 0) {
    findings.push_back(handles_finding(d, guess, guess > limits.handle_share, remedy));
  }
  if (share(d.conflicts, d.samples) > limits.conflict_share) {
    findings.push_back(conflicts_finding(d, remedy));
  }
  if (!d.unused.empty()) {
    const std::size_t unexplained =
        d.unused_points - std::min(left.trimmed_points, d.unused_points);
    const bool warns =
        filter != NoiseFilter::used && share(unexplained, points) > limits.unused_share;
    findings.push_back(unused_finding(d, points, warns, filter, left));
  }
  if (!d.contacts.empty()) findings.push_back(contacts_finding(d, left.manifold));
  if (noisy) {
    const bool warns = limits.noise_alone || std::any_of(findings.begin(), findings.end(),
                                                         [](const Finding& f) { return f.warns; });
    findings.insert(findings.begin() + place_of_noise, noise_finding(d, warns, filter));
  }
  return findings;
}

Finding clumps_finding(const NoiseCounters& noise, Points points) {
  const Point& at = points[noise.largest_clump_at.index()];
  return {
      "clumps",
      fmt::format("{} in {} left out as stray ones; {} has {}, near {}; if it is a body, "
                  "--noise-clump-share 0 keeps it",
                  counted(noise.clump_samples, "sample"), counted(noise.clumps, "clump"),
                  noise.clumps == 1 ? "it" : "the largest", noise.largest_clump, place_name(at)),
      noise.clumps,
      {{.at = at, .count = noise.largest_clump}},
      false};
}

void add_findings(JsonReport& report, const std::vector<Finding>& findings) {
  report.set_empty_array("findings");
  for (const Finding& finding : findings) {
    JsonReport entry;
    entry.set("kind", finding.kind);
    entry.set("message", finding.message);
    entry.set("count", finding.count);
    entry.set("warning", finding.warns);
    entry.set_empty_array("spots");
    for (const DoubtfulSpot& spot : finding.spots) {
      JsonReport where;
      where.set("at", std::vector<double>{spot.at.x, spot.at.y, spot.at.z});
      where.set("count", spot.count);
      where.set("size", spot.size);
      entry.append("spots", where);
    }
    report.append("findings", entry);
  }
}

void tell(Job& job, const Finding& finding) {
  if (finding.warns) {
    job.warn(finding.message);
  } else {
    job.say("note: {}", finding.message);
  }
}

void report_findings(Job& job, const std::vector<Finding>& findings) {
  add_findings(job.report(), findings);
  for (const Finding& finding : findings) tell(job, finding);
}

}  // namespace cocoon::app
