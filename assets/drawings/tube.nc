%
(A window of 40 mm x 80 degrees in a tube of 50 mm, and the end of the tube)
(X runs along the axis of the tube, A turns it. The zero lies on the axis.)
N10 G21 G90 G94
(window)
N20 G0 X-20 Y0 Z26 A-40
N30 M3 S1000
N40 G1 X20 F1200
N50 A40 F2400
N60 X-20 F1200
N70 A-40 F2400
N80 M5
(end)
N90 G0 X40
N100 G0 A0
N110 M3 S1000
N120 G1 A360 F2400
N130 M5
N140 M2
%
