package org.evoloop.config;

import java.util.List;

/**
 * The values given for an option in one place, before it is known whether the option exists.
 *
 * @param name as it is written, without dashes
 * @param list whether the values are in a list, which may be empty
 * @param readable whether the values could be read; if not, that has been reported
 */
record Entry(String name, Origin origin, boolean list, boolean readable, List<Value> values) {
    /** A value as it is written. */
    record Value(String text, Origin origin) {}
}
