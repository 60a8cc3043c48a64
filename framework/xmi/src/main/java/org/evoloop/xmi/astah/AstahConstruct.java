package org.evoloop.xmi.astah;

import java.util.Map;

/**
 * The term for an unsupported construct in messages, and what its author can do about it.
 *
 * @param words such as {@code synch state}
 * @param remedy the remedy
 */
record AstahConstruct(String words, String remedy) {
    private static final Map<String, AstahConstruct> BY_ELEMENT =
            Map.of("SynchState", new AstahConstruct("synch state", "draw the machine without it"));

    /** The construct for a UML element; an unknown element gets its own name. */
    static AstahConstruct of(String localName) {
        return BY_ELEMENT.getOrDefault(localName, new AstahConstruct("element " + localName, "remove it"));
    }
}
