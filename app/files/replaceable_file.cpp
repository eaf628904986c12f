#include "app/files/replaceable_file.h"

#ifdef __linux__
#include <fcntl.h>
#include <linux/capability.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace cocoon::app {

#ifdef __linux__

namespace {

// Root may by default, but not in every container.
bool may_act_as_any_owner() {
  __user_cap_header_struct header = {_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct data[_LINUX_CAPABILITY_U32S_3] = {};
  if (::syscall(SYS_capget, &header, data) != 0) return true;
  return (data[0].effective & (1U << CAP_FOWNER)) != 0;
}

}  // namespace

std::string obstacle_to_replacing(const std::filesystem::path& target) {
  struct statx file = {};
  if (::statx(AT_FDCWD, target.c_str(), AT_SYMLINK_NOFOLLOW, STATX_UID, &file) != 0) return {};
  if ((file.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0) return "it is a mount point";
  if ((file.stx_attributes & (STATX_ATTR_IMMUTABLE | STATX_ATTR_APPEND)) != 0) {
    return "it is marked as not to be changed (lsattr)";
  }
  const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
  struct stat place = {};
  if (::stat(folder.c_str(), &place) != 0 || (place.st_mode & S_ISVTX) == 0) return {};
  if (file.stx_uid == ::geteuid() || place.st_uid == ::geteuid()) return {};
  return may_act_as_any_owner() ? "" : "it is another user's, in a folder with the sticky bit";
}

#else

std::string obstacle_to_replacing(const std::filesystem::path&) { return {}; }

#endif

}  // namespace cocoon::app
