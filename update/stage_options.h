// Whether the options of the update's stages are numbers that they can work with.
#pragma once

namespace cocoon {

struct AngleOptions;
struct AstrayOptions;
struct ChoiceOptions;
struct ClosedOpeningOptions;
struct CloudSurfaceOptions;
struct ContradictedOptions;
struct CrowdedOptions;
struct CutOptions;
struct DenseTrialOptions;
struct DisprovedOptions;
struct GapOptions;
struct HandleOptions;
struct IslandOptions;
struct JoinOptions;
struct LostSurfaceOptions;
struct MadeUpOptions;
struct MovedCutOptions;
struct OrientOutwardOptions;
struct OutwardOptions;
struct OverlapOptions;
struct OverlookedOptions;
struct PinHoleOptions;
struct ReplaceOptions;
struct RimOptions;
struct RimSeamOptions;
struct SampledRegionOptions;
struct ScanEndOptions;
struct ShadowOptions;
struct SharedEdgeOptions;
struct ShiftOptions;
struct SightOptions;
struct StrayOptions;
struct TrimOptions;
struct UnchangedRestOptions;
struct UnconfirmedOptions;
struct UnscannedOptions;
struct UnusedChangeOptions;
struct UpdateOptions;
struct WallEdgeOptions;

// All throw InputError, with the name of the stage, unless distances, ratios and weights are 0 or
// more (infinity, too), shares of a whole from 0 to 1, cosines from -1 to 1, and margins from 0 to
// pi. Complexity: O(1).
void require_options(const char* stage, const AngleOptions& options);
void require_options(const char* stage, const AstrayOptions& options);
void require_options(const char* stage, const ChoiceOptions& options);
void require_options(const char* stage, const ClosedOpeningOptions& options);
void require_options(const char* stage, const CloudSurfaceOptions& options);
void require_options(const char* stage, const ContradictedOptions& options);
void require_options(const char* stage, const CrowdedOptions& options);
void require_options(const char* stage, const CutOptions& options);
void require_options(const char* stage, const DenseTrialOptions& options);
void require_options(const char* stage, const DisprovedOptions& options);
void require_options(const char* stage, const GapOptions& options);
void require_options(const char* stage, const HandleOptions& options);
void require_options(const char* stage, const SightOptions& options);
void require_options(const char* stage, const IslandOptions& options);
void require_options(const char* stage, const JoinOptions& options);
void require_options(const char* stage, const LostSurfaceOptions& options);
void require_options(const char* stage, const MadeUpOptions& options);
void require_options(const char* stage, const MovedCutOptions& options);
void require_options(const char* stage, const OrientOutwardOptions& options);
void require_options(const char* stage, const OutwardOptions& options);
void require_options(const char* stage, const OverlapOptions& options);
void require_options(const char* stage, const OverlookedOptions& options);
void require_options(const char* stage, const PinHoleOptions& options);
void require_options(const char* stage, const ReplaceOptions& options);
void require_options(const char* stage, const RimOptions& options);
void require_options(const char* stage, const RimSeamOptions& options);
void require_options(const char* stage, const SampledRegionOptions& options);
void require_options(const char* stage, const ScanEndOptions& options);
void require_options(const char* stage, const ShadowOptions& options);
void require_options(const char* stage, const SharedEdgeOptions& options);
void require_options(const char* stage, const ShiftOptions& options);
void require_options(const char* stage, const StrayOptions& options);
void require_options(const char* stage, const TrimOptions& options);
void require_options(const char* stage, const UnchangedRestOptions& options);
void require_options(const char* stage, const UnconfirmedOptions& options);
void require_options(const char* stage, const UnscannedOptions& options);
void require_options(const char* stage, const UnusedChangeOptions& options);
void require_options(const char* stage, const WallEdgeOptions& options);
// Of all stages of an update.
void require_options(const char* stage, const UpdateOptions& options);

}  // namespace cocoon
