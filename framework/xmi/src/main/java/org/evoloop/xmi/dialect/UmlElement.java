package org.evoloop.xmi.dialect;

import org.evoloop.statechart.Place;

/**
 * An element of UML in a file, of whichever version.
 *
 * <p>Threading: immutable once the file has been read.
 */
public interface UmlElement {
    /** Where it stands. */
    XmlNode node();

    /** The file in which it stands, for messages. */
    String file();

    /** Empty if the file gives none. */
    String id();

    /** The class of UML, such as {@code Transition}; empty if the file gives none. */
    String type();

    /** With single spaces; empty if it has none. */
    String name();

    /** Where it starts in the file, counted from 1. */
    default int line() {
        return node().line();
    }

    /** Where it is drawn. */
    default Place place() {
        return new Place(id(), line());
    }

    /** For messages. */
    default String label() {
        return Problems.label(name(), id());
    }
}
