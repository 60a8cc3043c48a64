package org.evoloop.xmi.astah;

import java.util.Map;

/**
 * How messages call a construct that cannot be used, and what its author can do about it.
 *
 * @param words such as {@code synch state}
 * @param mend what to do
 */
record AstahConstruct(String words, String mend) {
    private static final Map<String, AstahConstruct> BY_ELEMENT =
            Map.of("SynchState", new AstahConstruct("synch state", "draw the machine without it"));

    /** The construct that this element of UML stands for; an element that nobody knows stands for itself. */
    static AstahConstruct of(String localName) {
        return BY_ELEMENT.getOrDefault(localName, new AstahConstruct("element " + localName, "remove it"));
    }
}
