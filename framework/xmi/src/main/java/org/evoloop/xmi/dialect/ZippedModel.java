package org.evoloop.xmi.dialect;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;
import org.evoloop.statemachine.ModelException;

/** Unpacks zip files that contain one XMI document, such as ArgoUML's projects ({@code .zargo}). */
final class ZippedModel {
    private static final int NAMES_LISTED = 10;

    private ZippedModel() {}

    /**
     * The contents of a file, or of the document in it.
     *
     * @throws ModelException if it contains several documents
     * @throws IOException if it cannot be read
     */
    static InputStream unpacked(Path file) throws IOException {
        if (!isZip(file)) {
            return Files.newInputStream(file);
        }
        ZipFile zip;
        try {
            zip = new ZipFile(file.toFile());
        } catch (ZipException damaged) {
            // The parser will report that it is not XML.
            return Files.newInputStream(file);
        }
        try {
            List<? extends ZipEntry> documents = zip.stream()
                    .filter(entry -> entry.getName().endsWith(".xmi"))
                    .toList();
            if (documents.size() > 1) {
                throw new ModelException(file + ": is a zip archive with " + documents.size() + " XMI documents in it ("
                        + String.join(
                                ", ",
                                documents.stream()
                                        .limit(NAMES_LISTED)
                                        .map(ZipEntry::getName)
                                        .toList())
                        + "); unpack it and name one");
            }
            if (documents.size() == 1) {
                return new Unpacked(zip.getInputStream(documents.get(0)), zip);
            }
        } catch (IOException | RuntimeException failed) {
            zip.close();
            throw failed;
        }
        zip.close();
        return Files.newInputStream(file);
    }

    private static boolean isZip(Path file) throws IOException {
        try (InputStream bytes = Files.newInputStream(file)) {
            return bytes.read() == 'P' && bytes.read() == 'K';
        }
    }

    /** Closes the archive together with the document. */
    private static final class Unpacked extends FilterInputStream {
        private final ZipFile zip;

        Unpacked(InputStream document, ZipFile zip) {
            super(document);
            this.zip = zip;
        }

        @Override
        public void close() throws IOException {
            try (zip) {
                super.close();
            }
        }
    }
}
