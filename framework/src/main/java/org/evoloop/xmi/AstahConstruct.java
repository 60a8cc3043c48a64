package org.evoloop.xmi;

import java.util.Map;

/**
 * How messages call a construct that cannot be used yet, and what its author can do about it.
 *
 * @param words such as {@code guard}
 * @param mend what to do
 */
record AstahConstruct(String words, String mend) {
    private static final String ACTION_MEND =
            "remove it, actions belong into the code of the converter's components and new functions";

    private static final Map<String, AstahConstruct> BY_ELEMENT = Map.ofEntries(
            Map.entry("State.entry", new AstahConstruct("entry action", ACTION_MEND)),
            Map.entry("State.exit", new AstahConstruct("exit action", ACTION_MEND)),
            Map.entry("State.doActivity", new AstahConstruct("do action", ACTION_MEND)),
            Map.entry("Transition.effect", new AstahConstruct("effect", ACTION_MEND)),
            Map.entry(
                    "Transition.guard",
                    new AstahConstruct("guard", "remove it, and give each case an event of its own")),
            Map.entry(
                    "State.internalTransition",
                    new AstahConstruct("internal transition", "draw a transition from the state to itself")),
            Map.entry("State.deferrableEvent", new AstahConstruct("deferrable event", "remove it")),
            Map.entry("FinalState", new AstahConstruct("final state", "draw a state that no transition leaves")),
            Map.entry(
                    "SubmachineState",
                    new AstahConstruct("submachine state", "draw the submachine's states in this diagram")),
            Map.entry("StubState", new AstahConstruct("stub state", "end its transitions at a state of this diagram")),
            Map.entry("SynchState", new AstahConstruct("synch state", "draw the machine without parallel regions")));

    /** The construct that this element of UML stands for; an element that nobody knows stands for itself. */
    static AstahConstruct of(String localName) {
        return BY_ELEMENT.getOrDefault(localName, new AstahConstruct("element " + localName, "remove it"));
    }
}
