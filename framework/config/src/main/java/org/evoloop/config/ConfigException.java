package org.evoloop.config;

import java.util.List;

/**
 * A program's options are invalid. The message lists every mistake with its place and how to fix it, one per line.
 *
 * @since 0.1
 */
public final class ConfigException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    ConfigException(List<String> mistakes) {
        super(
                mistakes.size() == 1
                        ? mistakes.get(0)
                        : "the options have " + mistakes.size() + " mistakes:\n  " + String.join("\n  ", mistakes));
    }
}
