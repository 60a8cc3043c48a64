/* The complete model: the properties must hold in every interleaving. */

/* A number that is still used outside the core. */
#define EFFECT_OF 200
#define OUTSIDE(n) (flight == n || stray == n || lost == n || token[0] == EFFECT_OF + n || token[1] == EFFECT_OF + n)

#include "tables.pml"
#include "core.pml"
#include "properties.pml"
#ifdef PAPER
#include "paper.pml"
#else
#include "inputs.pml"
#include "turn.pml"
#endif
#include "world.pml"

init {
  atomic {
#define FILLING
    d_step {
#include "tables.pml"
      skip
    };
    run Device();
    run Adapter();
    run Carrier();
    run Timers();
    run Operator();
#ifndef A_SWAP_HAS_NO_DEADLINE
    if
    :: SWAPS > 0 -> run Deadline()
    :: else -> skip
    fi;
#endif
    if
    :: PRESSES > 0 -> run People()
    :: else -> skip
    fi;
    if
    :: RAISES + ASKS > 0 -> run Functions()
    :: else -> skip
    fi;
    if
    :: OWNS + JUMPS + GIVE_UPS + ENDS > 0 -> run DeviceByItself()
    :: else -> skip
    fi;
    run Faults()
  }
}

ltl drains { [] <> (waiting == 0 && !busy && !owed && untold == 0 && phase == OPEN) }
ltl swaps { [] (swap -> <> !swap) }
