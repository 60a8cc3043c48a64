package org.evoloop.line;

import java.io.IOException;

/**
 * Who is told of a wire.
 *
 * <p>Threading: called on the thread that reads.
 */
interface WireUser {
    /** It is there. */
    default void connected() throws IOException {}

    /** A line has come. */
    default void heard(String line) {}

    /** It is gone. */
    default void lost(String why) {}
}
