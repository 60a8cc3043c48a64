package org.evoloop.models;

import java.io.IOException;
import java.io.Reader;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.evoloop.statemachine.ModelException;

/** Reads text files written by hand. */
final class TextFile {
    private static final int LARGEST = 1_000_000;

    private TextFile() {}

    /**
     * The text of a file.
     *
     * @param what names the content in messages: {@code properties}
     * @throws ModelException if it is not a text file
     * @throws IOException if it cannot be read for another reason
     */
    static String read(Path file, String what) throws IOException {
        if (Files.isDirectory(file)) {
            throw new ModelException(file + ": is not a file; name a file of " + what);
        }
        CharBuffer text = CharBuffer.allocate(LARGEST + 1);
        // Limited, since it may be a pipe or a device.
        try (Reader in = Files.newBufferedReader(file)) {
            while (text.hasRemaining() && in.read(text) >= 0) {}
        } catch (NoSuchFileException missing) {
            throw new ModelException(file + ": does not exist; correct the path", missing);
        } catch (CharacterCodingException notText) {
            throw new ModelException(file + ": contains bytes that are not UTF-8; save it in UTF-8", notText);
        }
        if (!text.hasRemaining()) {
            throw new ModelException(file + ": is larger than 1 MB; name a file of " + what);
        }
        return text.flip().toString();
    }
}
