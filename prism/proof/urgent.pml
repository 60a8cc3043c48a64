/* Which events are urgent. Where the models have none, the specification is as small as it would be without them. */

#ifdef HAS_URGENT
/* Rules.isUrgent */
#define IS_URGENT(one) (one.kind == HEARD && urgent_table[IX(pair, 0, 0, one.what)])
#define IS_TAKEN_AT_ONCE(one) urgent_table[IX(pair, 0, system_at, one.what)]

/* Of those that wait and do not belong to a former visit: the first one's place, and whether the new model's state takes one. */
hidden byte first_urgent, urgent_waits, u;

/* Ledger.nextUrgent */
inline see_urgent() {
  first_urgent = waiting;
  urgent_waits = 0;
  u = waiting;
  do
  :: u > 0 ->
    u--;
    if
    :: IS_URGENT(line[u]) && line[u].visit != FORMER ->
      first_urgent = u;
      urgent_waits = urgent_waits || IS_TAKEN_AT_ONCE(line[u])
    :: else -> skip
    fi
  :: else -> break
  od
}

/* Ledger.overtakenBy: whether the occurrence in progress has to make way. */
#define IS_OVERTAKEN (busy && !IS_URGENT(work) && urgent_waits)
#define UNLESS_URGENT && !urgent_waits
#else
#define UNLESS_URGENT
#endif
