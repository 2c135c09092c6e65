# The address of an archive of Debian's packages. Sourced, not run: by Testing/Builds/roots.sh, and through
# bash by Python programs (cmake/wheel/linux_sdk.py).

# archive_address: prints ISTHMUS_MIRROR if that is set, else the first archive of Debian in this machine's apt
# configuration (not its security updates, nor third-party repositories); returns 1, with a message, if there is none.
archive_address()
{
  local address list
  address=${ISTHMUS_MIRROR:-}
  if [ -z "$address" ]; then
    # Origin and label are in the lists that apt-get update downloads. Without lists only an address of the form
    # that Debian's mirrors have is recognized; cloud images name a file of mirrors instead.
    # shellcheck disable=SC2016 # apt-get replaces these
    address=$({
      apt-get indextargets --format '$(ORIGIN)|$(LABEL)|$(COMPONENT)|$(REPO_URI)' 'Created-By: Packages'
      apt-get indextargets --no-release-info --format '||$(COMPONENT)|$(REPO_URI)' 'Created-By: Packages'
    } 2>/dev/null | awk -F '|' '
      $3 != "main" { next }
      $1 == "Debian" && $2 == "Debian" && !known { known = $4 }
      $1 != "" { listed[$4] = 1 }
      !($4 in listed) && $4 ~ "^[a-z]+://[^/]+/debian/?$|^mirror\\+file:.*/debian\\.list/?$" && !likely { likely = $4 }
      END { print known ? known : likely }') || true
    case $address in
      mirror+file:*)
        list=${address#mirror+file:}
        address=$(awk '/^[^#]/ && !found { found = $1 } END { print found }' "${list%/}" 2>/dev/null) || true
        ;;
    esac
  fi
  if [ -z "$address" ]; then
    echo "No archive of Debian's packages is known: the apt configuration names none, or apt-get update has not been" \
      "run. Name one with ISTHMUS_MIRROR=ADDRESS (the folder that has dists and pool)." >&2
    return 1
  fi
  printf '%s\n' "${address%/}"
}
