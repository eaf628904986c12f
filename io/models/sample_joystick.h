// The joysticks of Woo & Dey 2005 (Fig. 14): two different changes of one part.
#pragma once

#include "io/sample_models.h"

namespace cocoon {

// Before: a base, a boot, and a stick with a grip that leans forward and has a trigger.
// After: a console with two buttons on the base, before the stick. One cloud.
SampleModelDesign joystick_console_design();

// Before: the same. After: a larger grip with a hat switch, which swallows the upper part of the
// old one. One cloud, whose rim runs around the stick.
SampleModelDesign joystick_grip_design();

}  // namespace cocoon
