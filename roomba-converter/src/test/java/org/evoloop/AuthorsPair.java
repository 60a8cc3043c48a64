package org.evoloop;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The cleaning robot as the paper's authors have drawn it: their new states are called otherwise than ours, and the
 * second press is waited for by a time trigger of the model, which Astah writes with its brackets encoded.
 */
public final class AuthorsPair {
    private AuthorsPair() {}

    /** Writes a file with the diagrams {@code original} and {@code new}. */
    public static Path write(Path file) throws IOException {
        Path ours = Path.of(System.getProperty("evoloop.root"), "models", "cleaning-robot.xml");
        return Files.writeString(
                file,
                Files.readString(ours)
                        .replace("name=\"Move\"", "name=\"MoveToStartPoint\"")
                        .replace("name=\"timeout\"", "name=\"tm%282s%29\""));
    }
}
