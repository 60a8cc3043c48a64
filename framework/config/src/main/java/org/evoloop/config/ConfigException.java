package org.evoloop.config;

import java.util.List;

/**
 * What a program was told makes no sense. Its message holds every mistake with its place and how to mend it; one stands
 * on one line, several on one each.
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
