package org.evoloop.config;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.KeyStore;
import java.security.MessageDigest;
import java.security.cert.CertificateException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.util.Base64;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLServerSocket;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.TrustManagerFactory;
import javax.net.ssl.X509ExtendedTrustManager;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whom a client trusts that shakes hands with a real server, which has a certificate of its own. */
@SuppressWarnings("NullAway.Init") // set before all tests
class TrustTest {
    private static final String PASSWORD = "changeit";

    @TempDir
    private static Path folder;

    private static SSLContext server;
    private static Path certificate;
    private static String fingerprint;

    @BeforeAll
    static void makeACertificate() throws Exception {
        Path store = folder.resolve("server.p12");
        String keytool =
                Path.of(System.getProperty("java.home"), "bin", "keytool").toString();
        Process made = new ProcessBuilder(List.of(
                        keytool,
                        "-genkeypair",
                        "-keyalg",
                        "EC",
                        "-alias",
                        "server",
                        "-dname",
                        "CN=robot",
                        "-storepass",
                        PASSWORD,
                        "-keystore",
                        store.toString()))
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("keytool.log").toFile())
                .start();
        assertThat(made.waitFor()).isZero();
        KeyStore keys = KeyStore.getInstance("PKCS12");
        try (InputStream file = Files.newInputStream(store)) {
            keys.load(file, PASSWORD.toCharArray());
        }
        byte[] encoded = keys.getCertificate("server").getEncoded();
        fingerprint =
                HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(encoded));
        String text = Base64.getMimeEncoder(64, new byte[] {'\n'}).encodeToString(encoded);
        certificate = Files.writeString(
                folder.resolve("server.pem"), "-----BEGIN CERTIFICATE-----\n" + text + "\n-----END CERTIFICATE-----\n");
        KeyManagerFactory manager = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm());
        manager.init(keys, PASSWORD.toCharArray());
        server = SSLContext.getInstance("TLS");
        server.init(manager.getKeyManagers(), null, null);
    }

    /** Shakes hands, as a client that trusts only so. */
    private static void meet(TrustManagerFactory trust) throws Exception {
        SSLContext client = SSLContext.getInstance("TLS");
        client.init(null, trust.getTrustManagers(), null);
        InetAddress here = InetAddress.getByName("127.0.0.1");
        try (SSLServerSocket listening =
                (SSLServerSocket) server.getServerSocketFactory().createServerSocket(0, 1, here)) {
            CompletableFuture<Void> other = CompletableFuture.runAsync(() -> {
                try (SSLSocket accepted = (SSLSocket) listening.accept()) {
                    accepted.startHandshake();
                } catch (IOException refused) {
                    // The client says why.
                }
            });
            try (SSLSocket socket =
                    (SSLSocket) client.getSocketFactory().createSocket(here, listening.getLocalPort())) {
                socket.startHandshake();
            } finally {
                other.join();
            }
        }
    }

    @Test
    void theCertificateOfAFileIsTrusted() throws Exception {
        meet(Trust.in(certificate));
    }

    @Test
    void theCertificateWithItsFingerprintIsTrusted() throws Exception {
        meet(Trust.pinned(fingerprint));
        meet(Trust.pinned(fingerprint.toUpperCase(Locale.ROOT).replaceAll("(..)(?=.)", "$1:")));
    }

    @Test
    void anotherOneIsNot() {
        assertThatThrownBy(() -> meet(Trust.pinned("0".repeat(64))))
                .hasMessageContaining("it is not the pinned one, its sha256 is " + fingerprint);
    }

    @Test
    void oneThatNobodyHasConfirmedIsShownAndNotTrusted() {
        assertThatThrownBy(() -> meet(Trust.pinned("ask")))
                .hasMessageContaining("nobody has confirmed it yet, its sha256 is " + fingerprint)
                .hasMessageContaining("write sha256=" + fingerprint);
    }

    /** The JDK asks in one of these ways, by the kind of the connection. */
    @Test
    void theFingerprintAloneDecidesInEveryWay() throws Exception {
        X509ExtendedTrustManager right = manager(fingerprint);
        X509ExtendedTrustManager wrong = manager("0".repeat(64));
        X509Certificate[] chain;
        try (InputStream file = Files.newInputStream(certificate)) {
            chain = new X509Certificate[] {
                (X509Certificate) CertificateFactory.getInstance("X.509").generateCertificate(file)
            };
        }
        List<Check> ways = List.of(
                manager -> manager.checkServerTrusted(chain, "EC"),
                manager -> manager.checkServerTrusted(chain, "EC", (Socket) null),
                manager -> manager.checkServerTrusted(chain, "EC", (SSLEngine) null),
                manager -> manager.checkClientTrusted(chain, "EC"),
                manager -> manager.checkClientTrusted(chain, "EC", (Socket) null),
                manager -> manager.checkClientTrusted(chain, "EC", (SSLEngine) null));
        for (Check way : ways) {
            way.by(right);
            assertThatThrownBy(() -> way.by(wrong)).isInstanceOf(CertificateException.class);
        }
        assertThat(right.getAcceptedIssuers()).isEmpty();
    }

    private interface Check {
        void by(X509ExtendedTrustManager manager) throws CertificateException;
    }

    private static X509ExtendedTrustManager manager(String pinned) throws Exception {
        TrustManagerFactory factory = Trust.pinned(pinned);
        factory.init((KeyStore) null);
        return (X509ExtendedTrustManager) factory.getTrustManagers()[0];
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "abc", "zz"})
    void whatIsNoFingerprintIsRefused(String text) {
        assertThatThrownBy(() -> Trust.pinned(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("openssl x509");
    }

    @Test
    void aFileWithoutACertificateIsRefusedWithItsName() throws IOException {
        Path empty = Files.writeString(folder.resolve("empty.pem"), "none\n");
        assertThatThrownBy(() -> Trust.in(empty))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(empty.toString());
        assertThatThrownBy(() -> Trust.in(folder.resolve("missing.pem")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("missing.pem");
    }
}
