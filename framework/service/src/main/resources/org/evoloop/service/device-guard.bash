# The guard process: makes a device safe when the process at the other end of its standard input ends or stands still.
#   $1  after so many seconds without a beat that process stands still
#   $2  the command of sh that makes the device safe; it is repeated until it has succeeded
# It reads, a line each:  on N  a beat; from now on another one must come in time
#                         off   the device is safe by itself; nothing is awaited
#                         stop  make it safe now, unless that has been done since the last beat
#                         end   the process ends, and has left the device as it should be
# It answers:             on N, and after it has acted for want of a beat: safe N, or failed N
# What ends its process must not end it, nor may a terminal stop it.
trap '' HUP INT QUIT TERM PIPE TSTP
limit=$1 command=$2 number='' watching=

make_safe() {
  local answer=failed message=
  watching=
  for ((tries = 0; tries < 20; tries++)); do
    if message=$(sh -c "$command" 2>&1 </dev/null); then
      answer=safe
      break
    fi
    sleep 0.25
  done
  [ "$answer" = safe ] || printf 'evoloop-guard: the device could not be made safe: %s\n' "$message" >&2
  echo "$answer $number" 2>/dev/null
}

while :; do
  if [ "$watching" ]; then
    read -r -t "$limit" word rest
  else
    read -r word rest
  fi
  status=$?
  if [ "$status" -gt 128 ]; then
    # A guard that comes late itself finds a beat that came in time.
    read -t 0 || make_safe
  elif [ "$status" -ne 0 ]; then
    make_safe
    exit
  else
    case $word in
      on) watching=yes number=$rest; echo "on $number" 2>/dev/null ;;
      off) watching= ;;
      stop) [ -z "$watching" ] || make_safe ;;
      end) exit ;;
    esac
  fi
done
