/* Included twice: first declarations, then, with FILLING, the statements that fill the tables. */
#ifndef FILLING
//@ device 1 F
//@ device 2 G
//@ device 3 H
//@ system 1 F
//@ system 2 G
//@ system 3 H
//@ system 4 Alarm
//@ event 1 up
//@ event 2 down
//@ event 3 express
//@ event 4 fire
//@ event 5 timeout
#define EVENTS1 6
#define SYSTEM1 5
#define DEVICE1 4
#define INITIAL_DEVICE 1
#define INITIAL_SYSTEM 1
#define CAPACITY 1
#define IX(p, d, s, e) ((((p) * DEVICE1 + (d)) * SYSTEM1 + (s)) * EVENTS1 + (e))
#define OWN(d, e) own_table[(d) * EVENTS1 + (e)]
hidden int asked_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int acted_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int react_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int ask_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int settle_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int find_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int timer_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int fate_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int knows_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int function_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int elsewhere_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden byte own_table[DEVICE1 * EVENTS1];
hidden byte is_own_table[EVENTS1];
hidden byte has_table[EVENTS1];
hidden byte only_table[EVENTS1];
#define HAS_URGENT 1
hidden byte urgent_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
inline choose_button() {
  if
  :: event = 1
  :: event = 2
  :: event = 3
  :: event = 4
  fi
}
inline choose_asked() {
  if
  :: event = 1
  :: event = 2
  fi
}
inline choose_raised() {
  if
  :: event = 5
  fi
}
inline choose_device_state() {
  if
  :: event = 1
  :: event = 2
  :: event = 3
  fi
}
inline choose_own() {
  if
  :: OWN(device, 2) != 0 -> event = 2
  fi
}
#define CAN_ACT (OWN(device, 2) != 0)
#else
has_table[1] = 1;
own_table[1 * EVENTS1 + 1] = 2;
own_table[2 * EVENTS1 + 1] = 3;
has_table[2] = 1;
own_table[2 * EVENTS1 + 2] = 1;
own_table[3 * EVENTS1 + 2] = 2;
urgent_table[IX(0, 0, 0, 4)] = 1;
urgent_table[IX(0, 0, 1, 4)] = 1;
urgent_table[IX(0, 0, 2, 4)] = 1;
urgent_table[IX(0, 0, 3, 4)] = 1;
knows_table[IX(0, 0, 0, 1)] = 1;
knows_table[IX(0, 0, 0, 2)] = 1;
knows_table[IX(0, 0, 0, 3)] = 1;
knows_table[IX(0, 0, 0, 4)] = 1;
knows_table[IX(0, 0, 0, 5)] = 1;
find_table[IX(0, 1, 1, 0)] = 1;
settle_table[IX(0, 1, 1, 0)] = 20;
fate_table[IX(0, 1, 1, 0)] = 131;
asked_table[IX(0, 1, 1, 1)] = 16777513;
acted_table[IX(0, 1, 1, 1)] = 16777257;
react_table[IX(0, 1, 1, 1)] = 16777513;
ask_table[IX(0, 1, 1, 1)] = 19;
asked_table[IX(0, 1, 1, 2)] = 16;
acted_table[IX(0, 1, 1, 2)] = 16;
react_table[IX(0, 1, 1, 2)] = 16;
ask_table[IX(0, 1, 1, 2)] = 19;
asked_table[IX(0, 1, 1, 3)] = 16781625;
acted_table[IX(0, 1, 1, 3)] = 16781625;
react_table[IX(0, 1, 1, 3)] = 16781625;
ask_table[IX(0, 1, 1, 3)] = 19;
asked_table[IX(0, 1, 1, 4)] = 16777290;
acted_table[IX(0, 1, 1, 4)] = 16777290;
react_table[IX(0, 1, 1, 4)] = 16777290;
ask_table[IX(0, 1, 1, 4)] = 19;
asked_table[IX(0, 1, 1, 5)] = 16;
acted_table[IX(0, 1, 1, 5)] = 16;
react_table[IX(0, 1, 1, 5)] = 16;
ask_table[IX(0, 1, 1, 5)] = 19;
find_table[IX(0, 2, 1, 0)] = 2;
settle_table[IX(0, 2, 1, 0)] = 532;
fate_table[IX(0, 2, 1, 0)] = 131;
asked_table[IX(0, 2, 1, 1)] = 16777257;
acted_table[IX(0, 2, 1, 1)] = 16777769;
react_table[IX(0, 2, 1, 1)] = 16777257;
ask_table[IX(0, 2, 1, 1)] = 19;
asked_table[IX(0, 2, 1, 2)] = 16;
acted_table[IX(0, 2, 1, 2)] = 16;
react_table[IX(0, 2, 1, 2)] = 16;
ask_table[IX(0, 2, 1, 2)] = 19;
asked_table[IX(0, 2, 1, 3)] = 16777529;
acted_table[IX(0, 2, 1, 3)] = 16777529;
react_table[IX(0, 2, 1, 3)] = 16777529;
ask_table[IX(0, 2, 1, 3)] = 19;
asked_table[IX(0, 2, 1, 4)] = 16777802;
acted_table[IX(0, 2, 1, 4)] = 16777802;
react_table[IX(0, 2, 1, 4)] = 16777802;
ask_table[IX(0, 2, 1, 4)] = 19;
asked_table[IX(0, 2, 1, 5)] = 16;
acted_table[IX(0, 2, 1, 5)] = 16;
react_table[IX(0, 2, 1, 5)] = 16;
ask_table[IX(0, 2, 1, 5)] = 19;
find_table[IX(0, 3, 1, 0)] = 3;
settle_table[IX(0, 3, 1, 0)] = 8724;
fate_table[IX(0, 3, 1, 0)] = 131;
asked_table[IX(0, 3, 1, 1)] = 16777769;
acted_table[IX(0, 3, 1, 1)] = 16777769;
react_table[IX(0, 3, 1, 1)] = 16777769;
ask_table[IX(0, 3, 1, 1)] = 19;
asked_table[IX(0, 3, 1, 2)] = 16;
acted_table[IX(0, 3, 1, 2)] = 16;
react_table[IX(0, 3, 1, 2)] = 16;
ask_table[IX(0, 3, 1, 2)] = 19;
asked_table[IX(0, 3, 1, 3)] = 16777273;
acted_table[IX(0, 3, 1, 3)] = 16777273;
react_table[IX(0, 3, 1, 3)] = 16777273;
ask_table[IX(0, 3, 1, 3)] = 19;
asked_table[IX(0, 3, 1, 4)] = 16785994;
acted_table[IX(0, 3, 1, 4)] = 16785994;
react_table[IX(0, 3, 1, 4)] = 16785994;
ask_table[IX(0, 3, 1, 4)] = 19;
asked_table[IX(0, 3, 1, 5)] = 16;
acted_table[IX(0, 3, 1, 5)] = 16;
react_table[IX(0, 3, 1, 5)] = 16;
ask_table[IX(0, 3, 1, 5)] = 19;
find_table[IX(0, 1, 2, 0)] = 1;
settle_table[IX(0, 1, 2, 0)] = 292;
fate_table[IX(0, 1, 2, 0)] = 133;
asked_table[IX(0, 1, 2, 1)] = 16781625;
acted_table[IX(0, 1, 2, 1)] = 16777529;
react_table[IX(0, 1, 2, 1)] = 16781625;
ask_table[IX(0, 1, 2, 1)] = 35;
asked_table[IX(0, 1, 2, 2)] = 16777241;
acted_table[IX(0, 1, 2, 2)] = 16777241;
react_table[IX(0, 1, 2, 2)] = 16777241;
ask_table[IX(0, 1, 2, 2)] = 35;
asked_table[IX(0, 1, 2, 3)] = 32;
acted_table[IX(0, 1, 2, 3)] = 32;
react_table[IX(0, 1, 2, 3)] = 32;
ask_table[IX(0, 1, 2, 3)] = 35;
asked_table[IX(0, 1, 2, 4)] = 16777290;
acted_table[IX(0, 1, 2, 4)] = 16777290;
react_table[IX(0, 1, 2, 4)] = 16777290;
ask_table[IX(0, 1, 2, 4)] = 35;
asked_table[IX(0, 1, 2, 5)] = 32;
acted_table[IX(0, 1, 2, 5)] = 32;
react_table[IX(0, 1, 2, 5)] = 32;
ask_table[IX(0, 1, 2, 5)] = 35;
find_table[IX(0, 2, 2, 0)] = 2;
settle_table[IX(0, 2, 2, 0)] = 36;
fate_table[IX(0, 2, 2, 0)] = 133;
asked_table[IX(0, 2, 2, 1)] = 16777529;
acted_table[IX(0, 2, 2, 1)] = 16777273;
react_table[IX(0, 2, 2, 1)] = 16777529;
ask_table[IX(0, 2, 2, 1)] = 35;
asked_table[IX(0, 2, 2, 2)] = 16777753;
acted_table[IX(0, 2, 2, 2)] = 16777241;
react_table[IX(0, 2, 2, 2)] = 16777753;
ask_table[IX(0, 2, 2, 2)] = 35;
asked_table[IX(0, 2, 2, 3)] = 32;
acted_table[IX(0, 2, 2, 3)] = 32;
react_table[IX(0, 2, 2, 3)] = 32;
ask_table[IX(0, 2, 2, 3)] = 35;
asked_table[IX(0, 2, 2, 4)] = 16777802;
acted_table[IX(0, 2, 2, 4)] = 16777802;
react_table[IX(0, 2, 2, 4)] = 16777802;
ask_table[IX(0, 2, 2, 4)] = 35;
asked_table[IX(0, 2, 2, 5)] = 32;
acted_table[IX(0, 2, 2, 5)] = 32;
react_table[IX(0, 2, 2, 5)] = 32;
ask_table[IX(0, 2, 2, 5)] = 35;
find_table[IX(0, 3, 2, 0)] = 3;
settle_table[IX(0, 3, 2, 0)] = 548;
fate_table[IX(0, 3, 2, 0)] = 133;
asked_table[IX(0, 3, 2, 1)] = 16777273;
acted_table[IX(0, 3, 2, 1)] = 16777273;
react_table[IX(0, 3, 2, 1)] = 16777273;
ask_table[IX(0, 3, 2, 1)] = 35;
asked_table[IX(0, 3, 2, 2)] = 16785945;
acted_table[IX(0, 3, 2, 2)] = 16777753;
react_table[IX(0, 3, 2, 2)] = 16785945;
ask_table[IX(0, 3, 2, 2)] = 35;
asked_table[IX(0, 3, 2, 3)] = 32;
acted_table[IX(0, 3, 2, 3)] = 32;
react_table[IX(0, 3, 2, 3)] = 32;
ask_table[IX(0, 3, 2, 3)] = 35;
asked_table[IX(0, 3, 2, 4)] = 16785994;
acted_table[IX(0, 3, 2, 4)] = 16785994;
react_table[IX(0, 3, 2, 4)] = 16785994;
ask_table[IX(0, 3, 2, 4)] = 35;
asked_table[IX(0, 3, 2, 5)] = 32;
acted_table[IX(0, 3, 2, 5)] = 32;
react_table[IX(0, 3, 2, 5)] = 32;
ask_table[IX(0, 3, 2, 5)] = 35;
find_table[IX(0, 1, 3, 0)] = 1;
settle_table[IX(0, 1, 3, 0)] = 4404;
fate_table[IX(0, 1, 3, 0)] = 135;
asked_table[IX(0, 1, 3, 1)] = 48;
acted_table[IX(0, 1, 3, 1)] = 48;
react_table[IX(0, 1, 3, 1)] = 48;
ask_table[IX(0, 1, 3, 1)] = 51;
asked_table[IX(0, 1, 3, 2)] = 16777513;
acted_table[IX(0, 1, 3, 2)] = 16777513;
react_table[IX(0, 1, 3, 2)] = 16777513;
ask_table[IX(0, 1, 3, 2)] = 51;
asked_table[IX(0, 1, 3, 3)] = 16777241;
acted_table[IX(0, 1, 3, 3)] = 16777241;
react_table[IX(0, 1, 3, 3)] = 16777241;
ask_table[IX(0, 1, 3, 3)] = 51;
asked_table[IX(0, 1, 3, 4)] = 16777290;
acted_table[IX(0, 1, 3, 4)] = 16777290;
react_table[IX(0, 1, 3, 4)] = 16777290;
ask_table[IX(0, 1, 3, 4)] = 51;
asked_table[IX(0, 1, 3, 5)] = 48;
acted_table[IX(0, 1, 3, 5)] = 48;
react_table[IX(0, 1, 3, 5)] = 48;
ask_table[IX(0, 1, 3, 5)] = 51;
find_table[IX(0, 2, 3, 0)] = 2;
settle_table[IX(0, 2, 3, 0)] = 308;
fate_table[IX(0, 2, 3, 0)] = 135;
asked_table[IX(0, 2, 3, 1)] = 48;
acted_table[IX(0, 2, 3, 1)] = 48;
react_table[IX(0, 2, 3, 1)] = 48;
ask_table[IX(0, 2, 3, 1)] = 51;
asked_table[IX(0, 2, 3, 2)] = 16777257;
acted_table[IX(0, 2, 3, 2)] = 16777513;
react_table[IX(0, 2, 3, 2)] = 16777257;
ask_table[IX(0, 2, 3, 2)] = 51;
asked_table[IX(0, 2, 3, 3)] = 16777753;
acted_table[IX(0, 2, 3, 3)] = 16777753;
react_table[IX(0, 2, 3, 3)] = 16777753;
ask_table[IX(0, 2, 3, 3)] = 51;
asked_table[IX(0, 2, 3, 4)] = 16777802;
acted_table[IX(0, 2, 3, 4)] = 16777802;
react_table[IX(0, 2, 3, 4)] = 16777802;
ask_table[IX(0, 2, 3, 4)] = 51;
asked_table[IX(0, 2, 3, 5)] = 48;
acted_table[IX(0, 2, 3, 5)] = 48;
react_table[IX(0, 2, 3, 5)] = 48;
ask_table[IX(0, 2, 3, 5)] = 51;
find_table[IX(0, 3, 3, 0)] = 3;
settle_table[IX(0, 3, 3, 0)] = 52;
fate_table[IX(0, 3, 3, 0)] = 135;
asked_table[IX(0, 3, 3, 1)] = 48;
acted_table[IX(0, 3, 3, 1)] = 48;
react_table[IX(0, 3, 3, 1)] = 48;
ask_table[IX(0, 3, 3, 1)] = 51;
asked_table[IX(0, 3, 3, 2)] = 16777769;
acted_table[IX(0, 3, 3, 2)] = 16777257;
react_table[IX(0, 3, 3, 2)] = 16777769;
ask_table[IX(0, 3, 3, 2)] = 51;
asked_table[IX(0, 3, 3, 3)] = 16785945;
acted_table[IX(0, 3, 3, 3)] = 16785945;
react_table[IX(0, 3, 3, 3)] = 16785945;
ask_table[IX(0, 3, 3, 3)] = 51;
asked_table[IX(0, 3, 3, 4)] = 16785994;
acted_table[IX(0, 3, 3, 4)] = 16785994;
react_table[IX(0, 3, 3, 4)] = 16785994;
ask_table[IX(0, 3, 3, 4)] = 51;
asked_table[IX(0, 3, 3, 5)] = 48;
acted_table[IX(0, 3, 3, 5)] = 48;
react_table[IX(0, 3, 3, 5)] = 48;
ask_table[IX(0, 3, 3, 5)] = 51;
timer_table[IX(0, 0, 4, 0)] = 5;
function_table[IX(0, 0, 4, 0)] = 2;
find_table[IX(0, 1, 4, 0)] = 4;
settle_table[IX(0, 1, 4, 0)] = 68;
fate_table[IX(0, 1, 4, 0)] = 3;
asked_table[IX(0, 1, 4, 1)] = 64;
acted_table[IX(0, 1, 4, 1)] = 46;
react_table[IX(0, 1, 4, 1)] = 64;
ask_table[IX(0, 1, 4, 1)] = 67;
asked_table[IX(0, 1, 4, 2)] = 64;
acted_table[IX(0, 1, 4, 2)] = 64;
react_table[IX(0, 1, 4, 2)] = 64;
ask_table[IX(0, 1, 4, 2)] = 67;
asked_table[IX(0, 1, 4, 3)] = 64;
acted_table[IX(0, 1, 4, 3)] = 64;
react_table[IX(0, 1, 4, 3)] = 64;
ask_table[IX(0, 1, 4, 3)] = 67;
asked_table[IX(0, 1, 4, 4)] = 64;
acted_table[IX(0, 1, 4, 4)] = 64;
react_table[IX(0, 1, 4, 4)] = 64;
ask_table[IX(0, 1, 4, 4)] = 67;
asked_table[IX(0, 1, 4, 5)] = 16777241;
acted_table[IX(0, 1, 4, 5)] = 16777241;
react_table[IX(0, 1, 4, 5)] = 16777241;
ask_table[IX(0, 1, 4, 5)] = 67;
find_table[IX(0, 2, 4, 0)] = 2;
elsewhere_table[IX(0, 2, 4, 0)] = 1;
settle_table[IX(0, 2, 4, 0)] = 580;
fate_table[IX(0, 2, 4, 0)] = 3;
asked_table[IX(0, 2, 4, 1)] = 64;
acted_table[IX(0, 2, 4, 1)] = 62;
react_table[IX(0, 2, 4, 1)] = 64;
ask_table[IX(0, 2, 4, 1)] = 67;
asked_table[IX(0, 2, 4, 2)] = 64;
acted_table[IX(0, 2, 4, 2)] = 64;
react_table[IX(0, 2, 4, 2)] = 64;
ask_table[IX(0, 2, 4, 2)] = 67;
asked_table[IX(0, 2, 4, 3)] = 64;
acted_table[IX(0, 2, 4, 3)] = 64;
react_table[IX(0, 2, 4, 3)] = 64;
ask_table[IX(0, 2, 4, 3)] = 67;
asked_table[IX(0, 2, 4, 4)] = 64;
acted_table[IX(0, 2, 4, 4)] = 64;
react_table[IX(0, 2, 4, 4)] = 64;
ask_table[IX(0, 2, 4, 4)] = 67;
asked_table[IX(0, 2, 4, 5)] = 16777753;
acted_table[IX(0, 2, 4, 5)] = 16777753;
react_table[IX(0, 2, 4, 5)] = 16777753;
ask_table[IX(0, 2, 4, 5)] = 67;
find_table[IX(0, 3, 4, 0)] = 3;
elsewhere_table[IX(0, 3, 4, 0)] = 1;
settle_table[IX(0, 3, 4, 0)] = 8772;
fate_table[IX(0, 3, 4, 0)] = 3;
asked_table[IX(0, 3, 4, 1)] = 64;
acted_table[IX(0, 3, 4, 1)] = 64;
react_table[IX(0, 3, 4, 1)] = 64;
ask_table[IX(0, 3, 4, 1)] = 67;
asked_table[IX(0, 3, 4, 2)] = 64;
acted_table[IX(0, 3, 4, 2)] = 46;
react_table[IX(0, 3, 4, 2)] = 64;
ask_table[IX(0, 3, 4, 2)] = 67;
asked_table[IX(0, 3, 4, 3)] = 64;
acted_table[IX(0, 3, 4, 3)] = 64;
react_table[IX(0, 3, 4, 3)] = 64;
ask_table[IX(0, 3, 4, 3)] = 67;
asked_table[IX(0, 3, 4, 4)] = 64;
acted_table[IX(0, 3, 4, 4)] = 64;
react_table[IX(0, 3, 4, 4)] = 64;
ask_table[IX(0, 3, 4, 4)] = 67;
asked_table[IX(0, 3, 4, 5)] = 16785945;
acted_table[IX(0, 3, 4, 5)] = 16785945;
react_table[IX(0, 3, 4, 5)] = 16785945;
ask_table[IX(0, 3, 4, 5)] = 67;
knows_table[IX(1, 0, 0, 1)] = 1;
knows_table[IX(1, 0, 0, 2)] = 1;
find_table[IX(1, 1, 1, 0)] = 1;
settle_table[IX(1, 1, 1, 0)] = 20;
fate_table[IX(1, 1, 1, 0)] = 9;
asked_table[IX(1, 1, 1, 1)] = 16777513;
acted_table[IX(1, 1, 1, 1)] = 16777257;
react_table[IX(1, 1, 1, 1)] = 16777513;
ask_table[IX(1, 1, 1, 1)] = 19;
asked_table[IX(1, 1, 1, 2)] = 16;
acted_table[IX(1, 1, 1, 2)] = 16;
react_table[IX(1, 1, 1, 2)] = 16;
ask_table[IX(1, 1, 1, 2)] = 19;
asked_table[IX(1, 1, 1, 3)] = 16;
acted_table[IX(1, 1, 1, 3)] = 16;
react_table[IX(1, 1, 1, 3)] = 16;
ask_table[IX(1, 1, 1, 3)] = 19;
asked_table[IX(1, 1, 1, 4)] = 16;
acted_table[IX(1, 1, 1, 4)] = 16;
react_table[IX(1, 1, 1, 4)] = 16;
ask_table[IX(1, 1, 1, 4)] = 19;
asked_table[IX(1, 1, 1, 5)] = 16;
acted_table[IX(1, 1, 1, 5)] = 16;
react_table[IX(1, 1, 1, 5)] = 16;
ask_table[IX(1, 1, 1, 5)] = 19;
find_table[IX(1, 2, 1, 0)] = 2;
settle_table[IX(1, 2, 1, 0)] = 532;
fate_table[IX(1, 2, 1, 0)] = 265;
asked_table[IX(1, 2, 1, 1)] = 16777257;
acted_table[IX(1, 2, 1, 1)] = 16777769;
react_table[IX(1, 2, 1, 1)] = 16777257;
ask_table[IX(1, 2, 1, 1)] = 19;
asked_table[IX(1, 2, 1, 2)] = 16;
acted_table[IX(1, 2, 1, 2)] = 16;
react_table[IX(1, 2, 1, 2)] = 16;
ask_table[IX(1, 2, 1, 2)] = 19;
asked_table[IX(1, 2, 1, 3)] = 16;
acted_table[IX(1, 2, 1, 3)] = 16;
react_table[IX(1, 2, 1, 3)] = 16;
ask_table[IX(1, 2, 1, 3)] = 19;
asked_table[IX(1, 2, 1, 4)] = 16;
acted_table[IX(1, 2, 1, 4)] = 16;
react_table[IX(1, 2, 1, 4)] = 16;
ask_table[IX(1, 2, 1, 4)] = 19;
asked_table[IX(1, 2, 1, 5)] = 16;
acted_table[IX(1, 2, 1, 5)] = 16;
react_table[IX(1, 2, 1, 5)] = 16;
ask_table[IX(1, 2, 1, 5)] = 19;
find_table[IX(1, 3, 1, 0)] = 3;
settle_table[IX(1, 3, 1, 0)] = 8724;
fate_table[IX(1, 3, 1, 0)] = 265;
asked_table[IX(1, 3, 1, 1)] = 16777769;
acted_table[IX(1, 3, 1, 1)] = 16777769;
react_table[IX(1, 3, 1, 1)] = 16777769;
ask_table[IX(1, 3, 1, 1)] = 19;
asked_table[IX(1, 3, 1, 2)] = 16;
acted_table[IX(1, 3, 1, 2)] = 16;
react_table[IX(1, 3, 1, 2)] = 16;
ask_table[IX(1, 3, 1, 2)] = 19;
asked_table[IX(1, 3, 1, 3)] = 16;
acted_table[IX(1, 3, 1, 3)] = 16;
react_table[IX(1, 3, 1, 3)] = 16;
ask_table[IX(1, 3, 1, 3)] = 19;
asked_table[IX(1, 3, 1, 4)] = 16;
acted_table[IX(1, 3, 1, 4)] = 16;
react_table[IX(1, 3, 1, 4)] = 16;
ask_table[IX(1, 3, 1, 4)] = 19;
asked_table[IX(1, 3, 1, 5)] = 16;
acted_table[IX(1, 3, 1, 5)] = 16;
react_table[IX(1, 3, 1, 5)] = 16;
ask_table[IX(1, 3, 1, 5)] = 19;
find_table[IX(1, 1, 2, 0)] = 1;
settle_table[IX(1, 1, 2, 0)] = 292;
fate_table[IX(1, 1, 2, 0)] = 133;
asked_table[IX(1, 1, 2, 1)] = 16781625;
acted_table[IX(1, 1, 2, 1)] = 16777529;
react_table[IX(1, 1, 2, 1)] = 16781625;
ask_table[IX(1, 1, 2, 1)] = 35;
asked_table[IX(1, 1, 2, 2)] = 16777241;
acted_table[IX(1, 1, 2, 2)] = 16777241;
react_table[IX(1, 1, 2, 2)] = 16777241;
ask_table[IX(1, 1, 2, 2)] = 35;
asked_table[IX(1, 1, 2, 3)] = 32;
acted_table[IX(1, 1, 2, 3)] = 32;
react_table[IX(1, 1, 2, 3)] = 32;
ask_table[IX(1, 1, 2, 3)] = 35;
asked_table[IX(1, 1, 2, 4)] = 32;
acted_table[IX(1, 1, 2, 4)] = 32;
react_table[IX(1, 1, 2, 4)] = 32;
ask_table[IX(1, 1, 2, 4)] = 35;
asked_table[IX(1, 1, 2, 5)] = 32;
acted_table[IX(1, 1, 2, 5)] = 32;
react_table[IX(1, 1, 2, 5)] = 32;
ask_table[IX(1, 1, 2, 5)] = 35;
find_table[IX(1, 2, 2, 0)] = 2;
settle_table[IX(1, 2, 2, 0)] = 36;
fate_table[IX(1, 2, 2, 0)] = 133;
asked_table[IX(1, 2, 2, 1)] = 16777529;
acted_table[IX(1, 2, 2, 1)] = 16777273;
react_table[IX(1, 2, 2, 1)] = 16777529;
ask_table[IX(1, 2, 2, 1)] = 35;
asked_table[IX(1, 2, 2, 2)] = 16777753;
acted_table[IX(1, 2, 2, 2)] = 16777241;
react_table[IX(1, 2, 2, 2)] = 16777753;
ask_table[IX(1, 2, 2, 2)] = 35;
asked_table[IX(1, 2, 2, 3)] = 32;
acted_table[IX(1, 2, 2, 3)] = 32;
react_table[IX(1, 2, 2, 3)] = 32;
ask_table[IX(1, 2, 2, 3)] = 35;
asked_table[IX(1, 2, 2, 4)] = 32;
acted_table[IX(1, 2, 2, 4)] = 32;
react_table[IX(1, 2, 2, 4)] = 32;
ask_table[IX(1, 2, 2, 4)] = 35;
asked_table[IX(1, 2, 2, 5)] = 32;
acted_table[IX(1, 2, 2, 5)] = 32;
react_table[IX(1, 2, 2, 5)] = 32;
ask_table[IX(1, 2, 2, 5)] = 35;
find_table[IX(1, 3, 2, 0)] = 3;
settle_table[IX(1, 3, 2, 0)] = 548;
fate_table[IX(1, 3, 2, 0)] = 133;
asked_table[IX(1, 3, 2, 1)] = 16777273;
acted_table[IX(1, 3, 2, 1)] = 16777273;
react_table[IX(1, 3, 2, 1)] = 16777273;
ask_table[IX(1, 3, 2, 1)] = 35;
asked_table[IX(1, 3, 2, 2)] = 16785945;
acted_table[IX(1, 3, 2, 2)] = 16777753;
react_table[IX(1, 3, 2, 2)] = 16785945;
ask_table[IX(1, 3, 2, 2)] = 35;
asked_table[IX(1, 3, 2, 3)] = 32;
acted_table[IX(1, 3, 2, 3)] = 32;
react_table[IX(1, 3, 2, 3)] = 32;
ask_table[IX(1, 3, 2, 3)] = 35;
asked_table[IX(1, 3, 2, 4)] = 32;
acted_table[IX(1, 3, 2, 4)] = 32;
react_table[IX(1, 3, 2, 4)] = 32;
ask_table[IX(1, 3, 2, 4)] = 35;
asked_table[IX(1, 3, 2, 5)] = 32;
acted_table[IX(1, 3, 2, 5)] = 32;
react_table[IX(1, 3, 2, 5)] = 32;
ask_table[IX(1, 3, 2, 5)] = 35;
find_table[IX(1, 1, 3, 0)] = 1;
settle_table[IX(1, 1, 3, 0)] = 4404;
fate_table[IX(1, 1, 3, 0)] = 135;
asked_table[IX(1, 1, 3, 1)] = 48;
acted_table[IX(1, 1, 3, 1)] = 48;
react_table[IX(1, 1, 3, 1)] = 48;
ask_table[IX(1, 1, 3, 1)] = 51;
asked_table[IX(1, 1, 3, 2)] = 16777513;
acted_table[IX(1, 1, 3, 2)] = 16777513;
react_table[IX(1, 1, 3, 2)] = 16777513;
ask_table[IX(1, 1, 3, 2)] = 51;
asked_table[IX(1, 1, 3, 3)] = 48;
acted_table[IX(1, 1, 3, 3)] = 48;
react_table[IX(1, 1, 3, 3)] = 48;
ask_table[IX(1, 1, 3, 3)] = 51;
asked_table[IX(1, 1, 3, 4)] = 48;
acted_table[IX(1, 1, 3, 4)] = 48;
react_table[IX(1, 1, 3, 4)] = 48;
ask_table[IX(1, 1, 3, 4)] = 51;
asked_table[IX(1, 1, 3, 5)] = 48;
acted_table[IX(1, 1, 3, 5)] = 48;
react_table[IX(1, 1, 3, 5)] = 48;
ask_table[IX(1, 1, 3, 5)] = 51;
find_table[IX(1, 2, 3, 0)] = 2;
settle_table[IX(1, 2, 3, 0)] = 308;
fate_table[IX(1, 2, 3, 0)] = 135;
asked_table[IX(1, 2, 3, 1)] = 48;
acted_table[IX(1, 2, 3, 1)] = 48;
react_table[IX(1, 2, 3, 1)] = 48;
ask_table[IX(1, 2, 3, 1)] = 51;
asked_table[IX(1, 2, 3, 2)] = 16777257;
acted_table[IX(1, 2, 3, 2)] = 16777513;
react_table[IX(1, 2, 3, 2)] = 16777257;
ask_table[IX(1, 2, 3, 2)] = 51;
asked_table[IX(1, 2, 3, 3)] = 48;
acted_table[IX(1, 2, 3, 3)] = 48;
react_table[IX(1, 2, 3, 3)] = 48;
ask_table[IX(1, 2, 3, 3)] = 51;
asked_table[IX(1, 2, 3, 4)] = 48;
acted_table[IX(1, 2, 3, 4)] = 48;
react_table[IX(1, 2, 3, 4)] = 48;
ask_table[IX(1, 2, 3, 4)] = 51;
asked_table[IX(1, 2, 3, 5)] = 48;
acted_table[IX(1, 2, 3, 5)] = 48;
react_table[IX(1, 2, 3, 5)] = 48;
ask_table[IX(1, 2, 3, 5)] = 51;
find_table[IX(1, 3, 3, 0)] = 3;
settle_table[IX(1, 3, 3, 0)] = 52;
fate_table[IX(1, 3, 3, 0)] = 135;
asked_table[IX(1, 3, 3, 1)] = 48;
acted_table[IX(1, 3, 3, 1)] = 48;
react_table[IX(1, 3, 3, 1)] = 48;
ask_table[IX(1, 3, 3, 1)] = 51;
asked_table[IX(1, 3, 3, 2)] = 16777769;
acted_table[IX(1, 3, 3, 2)] = 16777257;
react_table[IX(1, 3, 3, 2)] = 16777769;
ask_table[IX(1, 3, 3, 2)] = 51;
asked_table[IX(1, 3, 3, 3)] = 48;
acted_table[IX(1, 3, 3, 3)] = 48;
react_table[IX(1, 3, 3, 3)] = 48;
ask_table[IX(1, 3, 3, 3)] = 51;
asked_table[IX(1, 3, 3, 4)] = 48;
acted_table[IX(1, 3, 3, 4)] = 48;
react_table[IX(1, 3, 3, 4)] = 48;
ask_table[IX(1, 3, 3, 4)] = 51;
asked_table[IX(1, 3, 3, 5)] = 48;
acted_table[IX(1, 3, 3, 5)] = 48;
react_table[IX(1, 3, 3, 5)] = 48;
ask_table[IX(1, 3, 3, 5)] = 51;
#endif
