package org.evoloop.xmi.dialect;

import org.evoloop.statechart.Place;

/**
 * A UML element in a file, of any UML version.
 *
 * <p>Threading: immutable once the file has been read.
 */
public interface UmlElement {
    /** The element of the file. */
    XmlNode node();

    /** The file that contains it, for messages. */
    String file();

    /** Its id; empty if the file gives none. */
    String id();

    /** Its UML class, such as {@code Transition}; empty if the file gives none. */
    String type();

    /** Its name with single spaces; empty if it has none. */
    String name();

    /** Its first line in the file, counted from 1. */
    default int line() {
        return node().line();
    }

    /** Its place in the file. */
    default Place place() {
        return new Place(id(), line());
    }

    /** For messages. */
    default String label() {
        return Problems.label(name(), id());
    }
}
