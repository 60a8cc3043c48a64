# The guard process: makes a device safe if the process at the other end of its standard input ends or stops running.
#   $1  the time limit for a heartbeat, in seconds
#   $2  the sh command that makes the device safe; it is tried up to 20 times
# It reads lines:  on N  a heartbeat; the next one must come in time
#                  off   the device is safe by itself; no heartbeat is expected
#                  stop  make the device safe now, unless that was done since the last heartbeat
#                  end   the process is ending, and the device is safe
# It answers:      on N, and after it has acted: safe N, or failed N
# Signals that end or stop the other process must not affect this one.
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
    # If this process was late itself, the heartbeat may have arrived in time.
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
