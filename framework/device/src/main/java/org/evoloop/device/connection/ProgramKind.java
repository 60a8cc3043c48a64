package org.evoloop.device.connection;

import java.util.List;
import org.evoloop.device.Connection;
import org.evoloop.device.ConnectionKind;
import org.evoloop.device.FileModels;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.line.LineTransport;
import org.jspecify.annotations.Nullable;

/**
 * {@code program: [python3, kettle.py]}: a program, by lines of text on its standard input and output.
 *
 * <p>Threading: as {@link ConnectionKind}.
 *
 * @since 0.1
 */
public final class ProgramKind implements ConnectionKind {
    /** For {@link java.util.ServiceLoader}. */
    public ProgramKind() {}

    @Override
    public String key() {
        return "program";
    }

    @Override
    public Connection read(String name, Section section, FileModels models) {
        return LineFileConnection.read(name, key(), transport(section), section, models);
    }

    private @Nullable LineTransport transport(Section section) {
        List<String> command =
                section.texts(key()).stream().map(Node.Text::value).toList();
        if (command.isEmpty()) {
            return null;
        }
        try {
            return LineTransport.program(command);
        } catch (IllegalArgumentException refused) {
            section.problem(key() + ": " + refused.getMessage());
            return null;
        }
    }
}
