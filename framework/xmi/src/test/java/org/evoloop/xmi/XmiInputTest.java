package org.evoloop.xmi;

import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.xmi.astah.AstahDocument.HEAD;
import static org.evoloop.xmi.astah.AstahDocument.offOn;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Random;
import java.util.zip.GZIPOutputStream;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.astah.AstahDocument;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Reading any file gives machines or one clear message. */
class XmiInputTest {
    @TempDir
    Path directory;

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "''                                   | is empty: export it again",
                "hello                                | is damaged or not XML, ",
                "<                                    | is damaged or not XML, ",
                "<XMI>                                | (line 1): export it again",
                "<XMI></XM>                           | is damaged or not XML, ",
                "<XMI a='1' a='2'/>                   | is damaged or not XML, ",
                "<XMI a='&lol;'/>                     | is damaged or not XML, ",
                "<?xml version='1.0' encoding='NONE'?><XMI/> | is in the unknown encoding NONE: save it in UTF-8",
                "<?xml version='1.0' encoding='UTF-16'?><XMI/> | is damaged or not XML, ",
                "<?xml version='1.0' encoding='UTF-32'?><XMI/> | contains bytes that are invalid in its declared encoding",
                "<!DOCTYPE XMI><XMI/>                 | contains a DOCTYPE, which is refused for security reasons (line 1): remove it",
                "<!DOCTYPE XMI SYSTEM 'file:///etc/passwd'><XMI/> | contains a DOCTYPE",
                "<!DOCTYPE XMI [<!ENTITY a 'b'>]><XMI>&a;</XMI> | contains a DOCTYPE",
                "PK\u0003\u0004 rest                  | is a zip archive, such as an Astah project (.asta), not XML: open it in Astah",
                "<book xmlns='urn:x' version='1.0'/> | found root element '{urn:x}book' of version '1.0', which is not supported",
                "<book/>                              | use XMI 1.1 from Astah (Tools > XML Input & Output > Save as XML Project) or UML 1.x",
                "<XMI><XMI.header><XMI.exporter>Odd</XMI.exporter></XMI.header></XMI>"
                        + " | found root element 'XMI' written by 'Odd', which is not supported",
            })
    void shouldSayWhatIsWrongWithTheFile(String content, String problem) throws IOException {
        Path file = Files.writeString(directory.resolve("bad.xml"), content);

        assertRefused(file, problem);
    }

    @Test
    void shouldGiveTheLineOfTheDamage() throws IOException {
        String document = new AstahDocument().add(offOn("m")).text();
        Path cut = Files.writeString(
                directory.resolve("cut.xml"), document.substring(0, document.indexOf("xmi.id=\"on\"")));
        Path wrong = directory.resolve("wrong.xml");
        Files.write(wrong, document.replace("Off", "\u00e9").getBytes(StandardCharsets.ISO_8859_1));

        assertRefused(cut, "is damaged or not XML, ");
        assertRefused(cut, "(line 14): export it again");
        assertRefused(wrong, "contains bytes that are invalid in its declared encoding (line ");
    }

    @Test
    void shouldRefuseWhatIsNotAFileOrCannotBeRead() throws IOException {
        assertRefused(directory, "is a directory; name a file in it");
        assertRefused(directory.resolve("missing.xml"), "does not exist; correct the path");
        Path secret = Files.writeString(directory.resolve("secret.xml"), HEAD);
        Files.setPosixFilePermissions(secret, PosixFilePermissions.fromString("---------"));
        Assumptions.assumeFalse(Files.isReadable(secret), "the superuser may read everything");
        assertRefused(secret, "cannot be read: permission denied; grant read permission");
    }

    @Test
    void shouldRefuseCompressedFilesAndNoise() throws IOException {
        ByteArrayOutputStream compressed = new ByteArrayOutputStream();
        try (GZIPOutputStream gzip = new GZIPOutputStream(compressed)) {
            gzip.write(HEAD.getBytes(StandardCharsets.UTF_8));
        }
        assertRefused(
                Files.write(directory.resolve("robot.xml.gz"), compressed.toByteArray()),
                "is compressed by gzip: unpack it with gunzip");
        assertRefused(Files.write(directory.resolve("zeros"), new byte[100]), "is damaged or not XML, ");
    }

    /**
     * With a flipped bit, or a lost or doubled piece, a machine may still be valid; otherwise there must be a clear
     * message.
     */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void shouldSurviveDamagedFiles(long seed) throws IOException {
        Path model = Path.of(System.getProperty("evoloop.root"), "models", "light-bulb.xml");
        byte[] original = Files.readAllBytes(model);
        Random random = new Random(seed);
        for (int round = 0; round < 150; round++) {
            Path file = Files.write(directory.resolve("damaged.xml"), damage(original, random));
            try {
                ModelFile.read(file).machines().forEach(XmiInputTest::use);
            } catch (ModelException refused) {
                if (!String.valueOf(refused.getMessage()).startsWith(file + ": ")) {
                    throw new AssertionError("seed " + seed + ", round " + round, refused);
                }
            } catch (RuntimeException escaped) {
                throw new AssertionError("seed " + seed + ", round " + round, escaped);
            }
        }
    }

    private static void use(XmiMachine machine) {
        try {
            machine.toStateMachine();
        } catch (ModelException refused) {
            if (!String.valueOf(refused.getMessage()).contains("state machine '")) {
                throw refused;
            }
        }
    }

    private static byte[] damage(byte[] original, Random random) {
        byte[] damaged = original.clone();
        int from = random.nextInt(original.length);
        int length = Math.min(1 + random.nextInt(200), original.length - from);
        switch (random.nextInt(3)) {
            case 0 -> damaged[from] ^= (byte) (1 << random.nextInt(8));
            case 1 -> System.arraycopy(original, from, damaged, random.nextInt(original.length - length + 1), length);
            default -> {
                damaged = new byte[original.length - length];
                System.arraycopy(original, 0, damaged, 0, from);
                System.arraycopy(original, from + length, damaged, from, damaged.length - from);
            }
        }
        return damaged;
    }

    private static void assertRefused(Path file, String problem) {
        assertThatThrownBy(() -> ModelFile.read(file))
                .isInstanceOf(ModelException.class)
                .hasMessageStartingWith(file + ": ")
                .hasMessageContaining(problem);
    }
}
