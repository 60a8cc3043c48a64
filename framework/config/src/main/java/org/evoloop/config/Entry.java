package org.evoloop.config;

import java.util.List;

/**
 * What is said somewhere about an option, before anybody knows whether there is one.
 *
 * @param name as it is written, without dashes
 * @param list whether the values stand in a list, which may be empty
 * @param readable whether the values are what is written; if not, that has been told
 */
record Entry(String name, Origin origin, boolean list, boolean readable, List<Value> values) {
    /** A value as it is written. */
    record Value(String text, Origin origin) {}

    static Entry of(String name, String text, Origin origin) {
        return new Entry(name, origin, false, true, List.of(new Value(text, origin)));
    }
}
