(* SPDX-License-Identifier: MIT *)
(* The sums and products of core/points/kernel/exact.h whose low parts are exact.
   Each operation is rounded to the nearest double, ties to even, also to a subnormal
   double, and nothing overflows. Flocq's theorems are about the same operations, with
   other signs. *)
From Coq Require Import Reals ZArith Lia Lra.
From Flocq Require Import Core Pff2Flocq Mult_error.

Open Scope R_scope.

Definition doubles := FLT_exp (-1074) 53.
Definition is_double := generic_format radix2 doubles.
Definition nearest := round radix2 doubles ZnearestE.

Lemma minus_nearest : forall x, nearest (- x) = - nearest x.
Proof. intro x. apply round_NE_opp. Qed.

Lemma symmetric : forall x : Z,
  negb (Z.even x) = negb (negb (Z.even (- (x + 1)))).
Proof. intro x. rewrite Z.even_opp, Z.even_add. now case (Z.even x). Qed.

(* two_sum: s = a + b, t = s - a, low = (a - (s - t)) + (b - t) *)
Theorem two_sum_is_exact : forall a b, is_double a -> is_double b ->
  let s := nearest (a + b) in
  let t := nearest (s - a) in
  let low := nearest (nearest (a - nearest (s - t)) + nearest (b - t)) in
  s + low = a + b.
Proof.
  intros a b Ha Hb s t low.
  apply (TwoSum_correct (-1074) 53); try easy; try lia; apply symmetric.
Qed.

(* fast_two_sum: s = a + b, low = b - (s - a) *)
Theorem fast_two_sum_is_exact : forall a b, is_double a -> is_double b ->
  Rabs b <= Rabs a ->
  let s := nearest (a + b) in
  let low := nearest (b - nearest (s - a)) in
  s + low = a + b.
Proof.
  intros a b Ha Hb order s low.
  assert (turned : nearest (s - a) = - nearest (a - s)).
  { rewrite <- minus_nearest. f_equal. ring. }
  unfold low. rewrite turned.
  replace (b - - nearest (a - s)) with (b + nearest (a - s)) by ring.
  apply (Fast2Sum_correct (-1074) 53); try easy; try lia; apply symmetric.
Qed.

(* two_prod: p = a b, low = fma(a, b, -p) *)
Theorem two_prod_is_exact : forall a b, is_double a -> is_double b ->
  (a * b <> 0 -> bpow radix2 (-969) <= Rabs (a * b)) ->
  let p := nearest (a * b) in
  let low := nearest (a * b - p) in
  p + low = a * b.
Proof.
  intros a b Ha Hb large p low.
  assert (rest : is_double (a * b - p)).
  { replace (a * b - p) with (- (p - a * b)) by ring.
    apply generic_format_opp.
    now apply mult_error_FLT; try lia; try apply valid_rnd_N. }
  unfold low, nearest. rewrite (round_generic _ _ _ _ rest). ring.
Qed.

(* The error of a sum is a double, on which count.h relies. *)
Theorem error_of_sum_is_double : forall a b, is_double a -> is_double b ->
  is_double (nearest (a + b) - (a + b)).
Proof.
  intros a b Ha Hb.
  pose proof (two_sum_is_exact a b Ha Hb) as H. cbv zeta in H.
  set (s := nearest (a + b)) in *.
  match type of H with s + ?low = _ =>
    replace (s - (a + b)) with (- low) by lra end.
  apply generic_format_opp, generic_format_round; try apply valid_rnd_N.
  now apply FLT_exp_valid.
Qed.
