// What the user asked for, as plain data. The only code that knows CLI11 is command_line.cpp,
// command_options.* and option_values.*.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "cocone/reconstruct.h"
#include "io/mesh_file_options.h"

namespace cocoon::app {

// The arguments of a command know its name: `command`.

// Options that every command has.
struct SharedArguments {
  int threads = 0;   // 0 = all cores it may use
  std::string json;  // file of the JSON report, "-" = standard output, empty = none
  bool quiet = false;
  bool verbose = false;
  bool progress = false;  // show progress even if standard error is no terminal
  // Points that are not finite are left out and counted, instead of being an error.
  bool skip_non_finite = false;
};

// Parameters of the Cocone stages; those not given keep the library's defaults. Degrees, as always
// outside the library.
struct SurfaceArguments {
  std::optional<double> rho;               // -r: ratio condition
  std::optional<double> alpha_deg;         // -f: normal condition
  std::optional<double> cocone_angle_deg;  // -c: half opening of the cocone about the tangent plane
  std::optional<double> sharp_angle_deg;   // -s: dihedral angle below which an edge is sharp
  Mode mode = Mode::robust;
  bool verify = false;        // certify triangulation and surface before writing
  bool keep_crowded = false;  // of updates: no samples are left out for being in layers
};

// What is done about noise before anything else.
enum class NoiseHandling {
  none,    // every sample counts
  robust,  // outliers and the inside of a layer of noise are left out
};

enum class SurfaceKind {
  tight,   // watertight
  cocone,  // open
};

// --thin and --noise robust of the commands that update: hold for the clouds of this call.
struct CloudFilterArguments {
  std::optional<double> thin;  // least distance of points that are used
  NoiseHandling noise = NoiseHandling::none;
  std::map<std::string, double> thresholds;  // those given, by name (thresholds.h)
};

struct DemoArguments {
  static constexpr const char* command = "demo";
  std::string folder = "demo-output";
};

struct SampleArguments {
  static constexpr const char* command = "sample";
  std::string name;
  std::string folder;  // empty: the model's name
  std::optional<std::size_t> points;
  std::optional<std::size_t> cloud_points;
  std::optional<std::uint64_t> seed;
};

struct ReconstructArguments {
  static constexpr const char* command = "reconstruct";
  std::string points;
  std::string mesh;
  SurfaceKind surface = SurfaceKind::tight;
  std::string session;  // empty: not written
  MeshWriteOptions writing;
  bool manifold = false;
  NoiseHandling noise = NoiseHandling::none;
  std::optional<double> densify;  // spacing of samples added to a mesh
  std::optional<double> thin;     // least distance of points that are used
  std::optional<double> trim;     // longest edge that is left, in local spacings
  SurfaceArguments parameters;
  std::optional<RadiusMode> radius;          // as of boundary
  bool deferred_seeding = true;              // of the peel, in robust mode
  bool second_look = true;                   // in robust mode, with the default radius
  bool cavities = false;                     // kept, in robust mode
  bool clean_up = true;                      // after the peel, in robust mode
  bool noise_keep_good = true;               // of the noise filter
  bool noise_spare_good = true;              // of the same
  std::map<std::string, double> thresholds;  // those given, by name (thresholds.h)
};

struct BoundaryArguments {
  static constexpr const char* command = "boundary";
  std::string points;
  std::string mesh;
  std::string loops;           // empty: not written
  bool label_samples = false;  // write which vertices are boundary samples
  MeshWriteOptions writing;
  std::optional<double> thin;  // least distance of points that are used
  std::optional<double> trim;  // longest edge of a triangle that stays, in local spacings
  SurfaceArguments parameters;
  std::optional<RadiusMode> radius;          // none: as the kind of surface has it
  std::map<std::string, double> thresholds;  // those given, by name (thresholds.h)
};

struct UpdateArguments {
  static constexpr const char* command = "update";
  std::string model;    // empty: that of the session
  std::string session;  // empty: none
  std::vector<std::string> clouds;
  std::string mesh;
  std::string map;   // empty: not written
  std::string html;  // empty: not written
  MeshWriteOptions writing;
  bool manifold = false;
  std::optional<double> densify;               // spacing of samples added to the model, a mesh
  bool keep_coarse = false;                    // never adds any without being told to
  std::vector<std::uint32_t> replaced_groups;  // whatever their angles
  std::vector<std::uint32_t> kept_groups;      // likewise
  SurfaceArguments parameters;
  CloudFilterArguments filter;
};

struct WatchArguments {
  static constexpr const char* command = "watch";
  std::string model;
  std::string folder;
  std::string mesh;
  std::string session;          // empty: beside the mesh
  double poll = 0.5;            // seconds between two looks into the folder
  double settle = 1;            // seconds that a file must have stayed the same
  bool once = false;            // stop when everything there has been looked at
  bool together = false;        // files that come together are views of one change
  std::size_t save_every = 32;  // clouds, until the whole session is written again
  MeshWriteOptions writing;
  std::optional<double> densify;  // spacing of samples added to the model, a mesh
  bool keep_coarse = false;       // never adds any without being told to
  SurfaceArguments parameters;
  CloudFilterArguments filter;
};

struct DelaunayArguments {
  static constexpr const char* command = "delaunay";
  std::string points;
  std::string file;
  bool ascii = false;
  bool verify = false;  // certify it before writing
};

struct CheckArguments {
  static constexpr const char* command = "check";
  std::string mesh;
  std::vector<std::string> required;  // words of check_requirements.h
  bool self_intersections = false;
  std::size_t handles = 0;  // so many of the narrowest are told
};

struct CompareArguments {
  static constexpr const char* command = "compare";
  std::string a;
  std::string b;
  std::size_t samples = 100000;
  std::optional<double> tolerance;  // how far samples may be off to count as within
  std::string mesh;                 // A with its distances from B; empty: not written
  MeshWriteOptions writing;
};

using Command = std::variant<DemoArguments, SampleArguments, ReconstructArguments,
                             BoundaryArguments, UpdateArguments, WatchArguments, DelaunayArguments,
                             CheckArguments, CompareArguments>;

struct CommandLine {
  SharedArguments shared;
  Command command;
};

// --help or --version: print the text, nothing else.
struct TextRequest {
  std::string text;
};

using Request = std::variant<TextRequest, CommandLine>;

// The command line is wrong (exit code 2); what() is one line.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Reads the arguments of main(). Looks at no file, but for what to say of an unknown option. Throws
// UsageError.
Request parse_command_line(int argc, const char* const* argv);

}  // namespace cocoon::app
